<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About Vybeg</source>
        <translation>О программе Vybeg</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Vybeg %1&lt;/h3&gt;&lt;p&gt;Standing waves in the free decay of hemispherical resonator gyros.&lt;/p&gt;&lt;p&gt;Qt %2, QCustomPlot %3&lt;/p&gt;&lt;p&gt;Free software: GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Vybeg %1&lt;/h3&gt;&lt;p&gt;Стоячие волны в свободном выбеге твердотельных волновых гироскопов.&lt;/p&gt;&lt;p&gt;Qt %2, QCustomPlot %3&lt;/p&gt;&lt;p&gt;Свободная программа: GNU General Public License версии 3 или новее.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Copy diagnostics</source>
        <translation>Копировать сведения</translation>
    </message>
</context>
<context>
    <name>Algorithm</name>
    <message>
        <source>1 In phase</source>
        <translation>1 Синфазный</translation>
    </message>
    <message>
        <source>(15)-(18): without the quadrature wave; a_B is not estimated. The starting point for the others.</source>
        <translation>(15)–(18): без учёта квадратурной волны; a_B не оценивается. Начальное приближение для остальных.</translation>
    </message>
    <message>
        <source>2 Phase shift</source>
        <translation>2 Фазовый сдвиг</translation>
    </message>
    <message>
        <source>(19)-(24): phase difference of the pick-off signals, by a delay of a quarter of a period.</source>
        <translation>(19)–(24): разность фаз измерительных сигналов, через задержку на четверть периода.</translation>
    </message>
    <message>
        <source>3 Moving axes</source>
        <translation>3 Подвижные оси</translation>
    </message>
    <message>
        <source>(26)-(30): signals in the axes of the standing waves; gives the orthogonality of (30).</source>
        <translation>(26)–(30): сигналы в осях стоячих волн; даёт проверку ортогональности (30).</translation>
    </message>
    <message>
        <source>4 Demodulation</source>
        <translation>4 Цифровая демодуляция</translation>
    </message>
    <message>
        <source>(31)-(33): synchronous averages at the carrier.</source>
        <translation>(31)–(33): синхронное усреднение на несущей частоте.</translation>
    </message>
    <message>
        <source>5 Conjugate gradient</source>
        <translation>5 Сопряжённый градиент</translation>
    </message>
    <message>
        <source>Minimum of the functional F over all five parameters at once; any window above one period.</source>
        <translation>Минимум функционала F сразу по всем пяти параметрам; любое окно длиннее одного периода.</translation>
    </message>
    <message>
        <source>6 Maximum likelihood</source>
        <translation>6 Макс. правдоподобие</translation>
    </message>
    <message>
        <source>The same minimum as 5 by the linear form (33), at a fraction of the cost; any window above one period.</source>
        <translation>Тот же минимум, что в 5, через линейную форму (33) и во много раз быстрее; любое окно длиннее одного периода.</translation>
    </message>
</context>
<context>
    <name>BatchColumn</name>
    <message>
        <source>Why the set has no result, or no verdict</source>
        <translation>Почему у набора нет результата или заключения</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Предупреждения</translation>
    </message>
    <message>
        <source>Their codes, the worst first</source>
        <translation>Их коды, сначала самые серьёзные</translation>
    </message>
    <message>
        <source>Bias, V</source>
        <translation>Смещение, В</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Температура, °C</translation>
    </message>
    <message>
        <source>Exchanged</source>
        <translation>Усилители переставлены</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Оператор</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Примечание</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Набор</translation>
    </message>
    <message>
        <source>Its name in the list</source>
        <translation>Его имя в списке</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Гироскоп</translation>
    </message>
    <message>
        <source>The first that the rows of the set name</source>
        <translation>Первое, что указано в строках набора</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Whether the set is computed, and has a result</source>
        <translation>Вычислен ли набор и есть ли результат</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Заключение</translation>
    </message>
    <message>
        <source>Of the comparison with the gyro&apos;s passport</source>
        <translation>Итог сравнения с паспортом гироскопа</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Изменилось</translation>
    </message>
    <message>
        <source>The parameters that differ from the passport</source>
        <translation>Параметры, отличающиеся от паспорта</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
    <message>
        <source>Structured: of known channels; free: where the data tell too little about it</source>
        <translation>С калиброванными датчиками; свободная — где данных для неё недостаточно</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Шум</translation>
    </message>
    <message>
        <source>White, or coloured about the carrier</source>
        <translation>Белый или окрашенный около несущей</translation>
    </message>
    <message>
        <source>χ² per dof</source>
        <translation>χ² на степень свободы</translation>
    </message>
    <message>
        <source>What the model leaves, in units of the noise: 1 is all noise</source>
        <translation>То, что оставляет модель, в единицах шума: 1 — только шум</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>As the list names them</source>
        <translation>Как они названы в списке</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Причина</translation>
    </message>
    <message>
        <source>A column of the list</source>
        <translation>Столбец списка</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Открыть…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Импорт…</translation>
    </message>
    <message>
        <source>Say how a file is to be read, and see at once what comes of it</source>
        <translation>Указать, как читать файл, и сразу увидеть, что получается</translation>
    </message>
    <message>
        <source>&amp;Close recording</source>
        <translation>&amp;Закрыть запись</translation>
    </message>
    <message>
        <source>Close the current recording and its analyses</source>
        <translation>Закрыть текущую запись и её расчёты</translation>
    </message>
    <message>
        <source>&amp;Export plots…</source>
        <translation>&amp;Экспорт графиков…</translation>
    </message>
    <message>
        <source>Save the plots as PNG, SVG or PDF</source>
        <translation>Сохранить графики в PNG, SVG или PDF</translation>
    </message>
    <message>
        <source>Export &amp;track…</source>
        <translation>Экспорт &amp;результатов…</translation>
    </message>
    <message>
        <source>Save the slow variables of the chosen analysis as CSV</source>
        <translation>Сохранить медленные переменные выбранного расчёта в CSV</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторить</translation>
    </message>
    <message>
        <source>&amp;Copy plots</source>
        <translation>&amp;Копировать графики</translation>
    </message>
    <message>
        <source>The plots as an image to the clipboard</source>
        <translation>Графики в буфер обмена как изображение</translation>
    </message>
    <message>
        <source>Copy &amp;table</source>
        <translation>Копировать &amp;таблицу</translation>
    </message>
    <message>
        <source>The values at the cursor to the clipboard, for a spreadsheet</source>
        <translation>Значения под курсором в буфер обмена, для электронной таблицы</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Крупнее</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>&amp;Мельче</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Показать вс&amp;ё</translation>
    </message>
    <message>
        <source>Show the whole time range (double click, Home)</source>
        <translation>Показать весь интервал времени (двойной щелчок, Home)</translation>
    </message>
    <message>
        <source>Zoom &amp;back</source>
        <translation>Предыду&amp;щий масштаб</translation>
    </message>
    <message>
        <source>Back in the zoom history (R)</source>
        <translation>Назад по истории масштабов (R)</translation>
    </message>
    <message>
        <source>Zoom fo&amp;rward</source>
        <translation>Масштаб &amp;вперёд</translation>
    </message>
    <message>
        <source>Forward in the zoom history</source>
        <translation>Вперёд по истории масштабов</translation>
    </message>
    <message>
        <source>One-&amp;sigma bands</source>
        <translation>Полос&amp;ы ±σ</translation>
    </message>
    <message>
        <source>&amp;Log axis for a_A</source>
        <translation>&amp;Логарифмическая шкала a_A</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Закрепить</translation>
    </message>
    <message>
        <source>Analyse the current recording with the settings of the panel and keep the analysis</source>
        <translation>Обработать текущую запись с настройками панели и оставить расчёт в списке</translation>
    </message>
    <message>
        <source>&amp;Live</source>
        <translation>&amp;Автопересчёт</translation>
    </message>
    <message>
        <source>Every change of a setting shows at once, in an analysis that follows the panel</source>
        <translation>Каждое изменение настройки сразу видно: один расчёт следует за панелью</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Прервать</translation>
    </message>
    <message>
        <source>Stop the analyses that are under way</source>
        <translation>Остановить идущие расчёты</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>How to use the program, the method and its formulas</source>
        <translation>Как работать с программой, метод и его формулы</translation>
    </message>
    <message>
        <source>Copy &amp;diagnostics</source>
        <translation>Копировать с&amp;ведения о программе</translation>
    </message>
    <message>
        <source>Versions and settings to the clipboard, for a report of a fault</source>
        <translation>Версии и настройки в буфер обмена, для сообщения об ошибке</translation>
    </message>
    <message>
        <source>&amp;About Vybeg</source>
        <translation>&amp;О программе</translation>
    </message>
    <message>
        <source>Save &amp;passport…</source>
        <translation>Сохранить &amp;паспорт…</translation>
    </message>
    <message>
        <source>Save what was identified from the set as the gyro&apos;s passport</source>
        <translation>Сохранить найденное по набору как паспорт гироскопа</translation>
    </message>
    <message>
        <source>Compare &amp;with passport…</source>
        <translation>Сравнить с п&amp;аспортом…</translation>
    </message>
    <message>
        <source>Which parameters of the resonator have changed since its passport</source>
        <translation>Какие параметры резонатора изменились по сравнению с паспортом</translation>
    </message>
    <message>
        <source>&amp;Identify resonator</source>
        <translation>&amp;Идентифицировать резонатор</translation>
    </message>
    <message>
        <source>Fit one resonator to all recordings of the set</source>
        <translation>Подогнать один резонатор ко всем записям набора</translation>
    </message>
    <message>
        <source>&amp;New set of recordings</source>
        <translation>Но&amp;вый набор записей</translation>
    </message>
    <message>
        <source>Recordings of another resonator, to be identified together</source>
        <translation>Записи другого резонатора, которые идентифицируются вместе</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>&amp;Сохранить сеанс</translation>
    </message>
    <message>
        <source>Recordings, settings, analyses, sets and view, to go on with later</source>
        <translation>Записи, настройки, расчёты, наборы и вид графиков — чтобы продолжить позже</translation>
    </message>
    <message>
        <source>S&amp;ave session as…</source>
        <translation>Сохранить сеанс &amp;как…</translation>
    </message>
    <message>
        <source>Trac&amp;ks</source>
        <translation>&amp;Ряды</translation>
    </message>
    <message>
        <source>The page with the slow variables over time</source>
        <translation>Страница с медленными переменными во времени</translation>
    </message>
    <message>
        <source>Resi&amp;duals</source>
        <translation>Невя&amp;зки</translation>
    </message>
    <message>
        <source>The page with spectrum, distribution and autocorrelation of the residuals of an analysis</source>
        <translation>Страница со спектром, распределением и автокорреляцией невязок расчёта</translation>
    </message>
    <message>
        <source>Take back the last change of settings, analyses or sets</source>
        <translation>Отменить последнее изменение настроек, расчётов или наборов</translation>
    </message>
    <message>
        <source>Make the change again that was taken back</source>
        <translation>Повторить отменённое изменение</translation>
    </message>
    <message>
        <source>Reso&amp;nator</source>
        <translation>Р&amp;езонатор</translation>
    </message>
    <message>
        <source>The page with the resonator of a set: parameters, rim, drift</source>
        <translation>Страница с резонатором набора: параметры, кромка, дрейф</translation>
    </message>
    <message>
        <source>&amp;Windows</source>
        <translation>&amp;Окна</translation>
    </message>
    <message>
        <source>The page with scatter, bound and leakage against the length of the window, and the recommended window</source>
        <translation>Страница с разбросом, границей и утечкой в зависимости от длины окна и с рекомендуемым окном</translation>
    </message>
    <message>
        <source>Si&amp;gnals</source>
        <translation>&amp;Сигналы</translation>
    </message>
    <message>
        <source>The page with the samples, the wave fitted to them and the residual</source>
        <translation>Страница с отсчётами, модельной волной и невязкой</translation>
    </message>
    <message>
        <source>Gyro&apos;s &amp;data…</source>
        <translation>&amp;Данные гироскопа…</translation>
    </message>
    <message>
        <source>Serial number, type, operator and comment of the session</source>
        <translation>Заводской номер, тип, оператор и примечание сеанса</translation>
    </message>
    <message>
        <source>&amp;Limits…</source>
        <translation>&amp;Пределы…</translation>
    </message>
    <message>
        <source>What the resonator&apos;s parameters have to keep</source>
        <translation>Каким значениям должны удовлетворять параметры резонатора</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>О&amp;тчёт…</translation>
    </message>
    <message>
        <source>A PDF of the recordings: settings, plots, resonator with its uncertainty budget, events, warnings</source>
        <translation>PDF о записях: настройки, графики, резонатор с бюджетом неопределённости, события, предупреждения</translation>
    </message>
    <message>
        <source>Open recordings of a free decay, a measurement list, or a session</source>
        <translation>Открыть записи свободного выбега, список измерений или сеанс</translation>
    </message>
    <message>
        <source>Open &amp;database…</source>
        <translation>Открыть &amp;базу данных…</translation>
    </message>
    <message>
        <source>Open a database of results, for the history of its gyros</source>
        <translation>Открыть базу результатов, чтобы видеть историю её гироскопов</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;История</translation>
    </message>
    <message>
        <source>The page with the parameters of each gyro over all results of the laboratory&apos;s database</source>
        <translation>Страница с параметрами каждого гироскопа по всем результатам базы данных лаборатории</translation>
    </message>
    <message>
        <source>&amp;Batch…</source>
        <translation>Пакетная о&amp;бработка…</translation>
    </message>
    <message>
        <source>Compute many sets of a list or folder into a table, without opening their recordings</source>
        <translation>Вычислить много наборов из списка или папки в таблицу, не открывая записи</translation>
    </message>
    <message>
        <source>Settings of the anal&amp;ysis</source>
        <translation>&amp;Настройки обработки</translation>
    </message>
    <message>
        <source>The settings beside the plots; without them the plots are wider</source>
        <translation>Настройки рядом с графиками; без них графики шире</translation>
    </message>
    <message>
        <source>Wa&amp;ve</source>
        <translation>Волна</translation>
    </message>
    <message>
        <source>The waves at the mouse beside the plots, as figures: the amplitude around the rim, D against C</source>
        <translation>Волны под указателем мыши рядом с графиками, фигурами: амплитуда вдоль кромки, D от C</translation>
    </message>
    <message>
        <source>Fitted wave</source>
        <translation>Модельная волна</translation>
    </message>
    <message>
        <source>The wave of the chosen analysis over the samples of the page Signals: zoomed out its amplitude, zoomed in the wave itself</source>
        <translation>Волна выбранного расчёта поверх отсчётов страницы «Сигналы»: издали — её амплитуда, вблизи — сама волна</translation>
    </message>
    <message>
        <source>Article&apos;s &amp;figure…</source>
        <translation>Рисунок статьи…</translation>
    </message>
    <message>
        <source>The article&apos;s figure: a column for each analysis that is shown, with the scatter of its windows</source>
        <translation>Рисунок статьи: столбец на каждый показанный расчёт, с разбросом его окон</translation>
    </message>
    <message>
        <source>Open &amp;logs…</source>
        <translation>Открыть &amp;журналы…</translation>
    </message>
    <message>
        <source>Open logs of a controller, a lock-in or a phasemeter in place of recordings, and identify their resonator</source>
        <translation>Открыть вместо записей журналы контроллера, синхронного детектора или фазометра и найти по ним резонатор</translation>
    </message>
    <message>
        <source>Open w&amp;hole-angle logs…</source>
        <translation>Открыть журналы интегрирующего режи&amp;ма…</translation>
    </message>
    <message>
        <source>Open logs of a wave whose amplitude is held while it turns, for its drift against the angle</source>
        <translation>Открыть журналы волны, амплитуду которой удерживают, пока она поворачивается, — для её дрейфа по углу</translation>
    </message>
    <message>
        <source>Drift of the whole angl&amp;e</source>
        <translation>&amp;Дрейф в интегрирующем режиме</translation>
    </message>
    <message>
        <source>The page with the drift of whole-angle logs against the angle, and what it and the efforts say of the resonator</source>
        <translation>Страница с дрейфом по углу из журналов интегрирующего режима и тем, что он и воздействия говорят о резонаторе</translation>
    </message>
    <message>
        <source>A&amp;xis limits…</source>
        <translation>&amp;Пределы шкалы…</translation>
    </message>
    <message>
        <source>Limits of the value axis of the plot with the focus or under the mouse</source>
        <translation>Пределы шкалы значений того графика, который выбран с клавиатуры или под указателем</translation>
    </message>
</context>
<context>
    <name>DisplayUnits</name>
    <message>
        <source>dB</source>
        <translation>дБ</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>рад</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>рад/с</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>млн⁻¹</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>V</source>
        <translation>В</translation>
    </message>
    <message>
        <source>mV</source>
        <translation>мВ</translation>
    </message>
</context>
<context>
    <name>Drift</name>
    <message>
        <source>means over %1°</source>
        <translation>средние по %1°</translation>
    </message>
    <message>
        <source>harmonics 2 and 4</source>
        <translation>гармоники 2 и 4</translation>
    </message>
    <message>
        <source>%1, %2 without</source>
        <translation>%1, без угла %2</translation>
    </message>
    <message>
        <source>dθ_A/dt less the turn</source>
        <translation>dθ_A/dt без самого поворота</translation>
    </message>
    <message>
        <source>%1 (left out)</source>
        <translation>%1 (исключён)</translation>
    </message>
    <message>
        <source>All logs</source>
        <translation>Все журналы</translation>
    </message>
    <message>
        <source>Turn dθ_A/dt</source>
        <translation>Поворот dθ_A/dt</translation>
    </message>
    <message>
        <source>Mean rate over the angle: input rate and bias. Each log has its own</source>
        <translation>Средняя по углу скорость: входная скорость и смещение нуля. У каждого журнала своя</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длительность</translation>
    </message>
    <message>
        <source>Turn of the wave</source>
        <translation>Поворот волны</translation>
    </message>
    <message>
        <source>From the least to the greatest angle</source>
        <translation>От наименьшего угла до наибольшего</translation>
    </message>
    <message>
        <source>Rows with an angle</source>
        <translation>Строк с углом</translation>
    </message>
    <message>
        <source>Four times the fourth harmonic of the drift</source>
        <translation>Учетверённая четвёртая гармоника дрейфа</translation>
    </message>
    <message>
        <source>Axis of larger damping, from the drift</source>
        <translation>Ось большего затухания, по дрейфу</translation>
    </message>
    <message>
        <source>2ρ/g, ρ the fourth harmonic of the amplitude effort over its mean</source>
        <translation>2ρ/g, где ρ — отношение четвёртой гармоники воздействия на амплитуду к его среднему</translation>
    </message>
    <message>
        <source>From the quadrature effort against the amplitude effort</source>
        <translation>По воздействию на квадратуру в сравнении с воздействием на амплитуду</translation>
    </message>
    <message>
        <source>Axis of the mode with the higher frequency, from the quadrature effort</source>
        <translation>Ось моды с большей частотой, по воздействию на квадратуру</translation>
    </message>
    <message>
        <source>Turn: the logs agree, χ² %1 of %2.</source>
        <translation>Поворот: журналы согласны, χ² %1 при %2.</translation>
    </message>
    <message>
        <source>Turn: the logs differ, χ² %1 of %2, which is no fault.</source>
        <translation>Поворот: журналы различаются, χ² %1 при %2; это не ошибка.</translation>
    </message>
    <message>
        <source>Harmonic %3: the logs agree, χ² %1 of %2.</source>
        <translation>Гармоника %3: журналы согласны, χ² %1 при %2.</translation>
    </message>
    <message>
        <source>Harmonic %3: the logs differ, χ² %1 of %2.</source>
        <translation>Гармоника %3: журналы расходятся, χ² %1 при %2.</translation>
    </message>
    <message>
        <source>Of one log it is not known whether another one would agree with it.</source>
        <translation>Журнал один: согласуется ли с ним другой, неизвестно.</translation>
    </message>
    <message>
        <source>± is the statistical standard deviation. u, where it differs, holds the tolerances of the channels too: κ ± %1, ε ± %2°.</source>
        <translation>± — статистическое СКО. u, если она отличается, содержит и допуски каналов: κ ± %1, ε ± %2°.</translation>
    </message>
</context>
<context>
    <name>Duration</name>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 мин</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 ч</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Clipped</source>
        <translation>Ограничение</translation>
    </message>
    <message>
        <source>The wave moves inside its windows</source>
        <translation>Волна меняется внутри окон</translation>
    </message>
    <message>
        <source>The delay reaches beyond the samples</source>
        <translation>Задержка выходит за край записи</translation>
    </message>
    <message>
        <source>Transient of the band-pass</source>
        <translation>Переходный процесс фильтра</translation>
    </message>
    <message>
        <source>Not converged</source>
        <translation>Нет сходимости</translation>
    </message>
    <message>
        <source>Samples are missing</source>
        <translation>Нет отсчётов</translation>
    </message>
    <message numerus="yes">
        <source>(And %n more of the kind.)</source>
        <translation>
            <numerusform>(И ещё %n такого рода.)</numerusform>
            <numerusform>(И ещё %n такого рода.)</numerusform>
            <numerusform>(И ещё %n такого рода.)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(And %n more place(s).)</source>
        <translation>
            <numerusform>(И ещё %n место.)</numerusform>
            <numerusform>(И ещё %n места.)</numerusform>
            <numerusform>(И ещё %n мест.)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>(And %n more place(s); %1 samples in all.)</source>
        <translation>
            <numerusform>(И ещё %n место; всего отсчётов: %1.)</numerusform>
            <numerusform>(И ещё %n места; всего отсчётов: %1.)</numerusform>
            <numerusform>(И ещё %n мест; всего отсчётов: %1.)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>ещё %n</numerusform>
            <numerusform>ещё %n</numerusform>
            <numerusform>ещё %n</numerusform>
        </translation>
    </message>
    <message>
        <source>a_B is not estimated</source>
        <translation>a_B не оценивается</translation>
    </message>
    <message>
        <source>circular wave: no angle</source>
        <translation>круговая волна: угла нет</translation>
    </message>
    <message>
        <source>samples are missing</source>
        <translation>нет отсчётов</translation>
    </message>
    <message>
        <source>transient of the band-pass</source>
        <translation>переходный процесс фильтра</translation>
    </message>
    <message>
        <source>the delay reaches beyond the samples</source>
        <translation>задержка выходит за край записи</translation>
    </message>
    <message>
        <source>leakage above one standard deviation</source>
        <translation>утечка больше одного СКО</translation>
    </message>
    <message>
        <source>the wave moves inside the window</source>
        <translation>волна меняется внутри окна</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>нет сходимости</translation>
    </message>
    <message>
        <source>frequency at its bound</source>
        <translation>частота на границе поиска</translation>
    </message>
    <message>
        <source>samples at the rail</source>
        <translation>отсчёты на пределе шкалы</translation>
    </message>
    <message>
        <source>2θ_A passes %1, rising</source>
        <translation>2θ_A проходит %1, возрастая</translation>
    </message>
    <message>
        <source>2θ_A passes %1, falling</source>
        <translation>2θ_A проходит %1, убывая</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>text</source>
        <translation>текст</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>без заголовка</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>табуляция</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>точка с запятой</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>запятая</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>черта</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>пробелы</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>десятичная запятая</translation>
    </message>
    <message>
        <source>16 bit integer</source>
        <translation>целые 16 бит</translation>
    </message>
    <message>
        <source>32 bit integer</source>
        <translation>целые 32 бита</translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation>вещественные 32 бита</translation>
    </message>
    <message>
        <source>64 bit float</source>
        <translation>вещественные 64 бита</translation>
    </message>
    <message>
        <source>big endian</source>
        <translation>старший байт первым</translation>
    </message>
    <message>
        <source>little endian</source>
        <translation>младший байт первым</translation>
    </message>
    <message>
        <source>Signed 8 bit PCM</source>
        <translation>ИКМ 8 бит со знаком</translation>
    </message>
    <message>
        <source>Unsigned 8 bit PCM</source>
        <translation>ИКМ 8 бит без знака</translation>
    </message>
    <message>
        <source>Signed 16 bit PCM</source>
        <translation>ИКМ 16 бит</translation>
    </message>
    <message>
        <source>Signed 24 bit PCM</source>
        <translation>ИКМ 24 бита</translation>
    </message>
    <message>
        <source>Signed 32 bit PCM</source>
        <translation>ИКМ 32 бита</translation>
    </message>
    <message numerus="yes">
        <source>%n channel(s)</source>
        <translation>
            <numerusform>%n канал</numerusform>
            <numerusform>%n канала</numerusform>
            <numerusform>%n каналов</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n column(s)</source>
        <translation>
            <numerusform>%n столбец</numerusform>
            <numerusform>%n столбца</numerusform>
            <numerusform>%n столбцов</numerusform>
        </translation>
    </message>
    <message>
        <source>Fortran order</source>
        <translation>порядок Fortran</translation>
    </message>
    <message>
        <source>C order</source>
        <translation>порядок C</translation>
    </message>
    <message>
        <source>8 bit integer</source>
        <translation>целые 8 бит</translation>
    </message>
    <message>
        <source>8 bit unsigned integer</source>
        <translation>целые 8 бит без знака</translation>
    </message>
    <message>
        <source>16 bit unsigned integer</source>
        <translation>целые 16 бит без знака</translation>
    </message>
    <message>
        <source>16 bit float</source>
        <translation>вещественные 16 бит</translation>
    </message>
    <message>
        <source>24 bit integer</source>
        <translation>целые 24 бита</translation>
    </message>
    <message>
        <source>32 bit unsigned integer</source>
        <translation>целые 32 бита без знака</translation>
    </message>
    <message>
        <source>64 bit integer</source>
        <translation>целые 64 бита</translation>
    </message>
    <message>
        <source>64 bit unsigned integer</source>
        <translation>целые 64 бита без знака</translation>
    </message>
    <message>
        <source>dataset 58b</source>
        <translation>набор данных 58b</translation>
    </message>
    <message>
        <source>dataset 58</source>
        <translation>набор данных 58</translation>
    </message>
</context>
<context>
    <name>History</name>
    <message>
        <source>values ± u</source>
        <translation>значения ± u</translation>
    </message>
    <message>
        <source>limits need %1 results, there are %2</source>
        <translation>для пределов нужно результатов: %1, есть: %2</translation>
    </message>
    <message>
        <source>the baseline has a trend</source>
        <translation>в исходных результатах есть тренд</translation>
    </message>
    <message>
        <source>neighbours in the baseline are correlated</source>
        <translation>соседние исходные результаты коррелированы</translation>
    </message>
    <message>
        <source>Limits need %1 results of this gyro that differ and have about the same uncertainty; the baseline has %2.</source>
        <translation>Для пределов нужно результатов этого гироскопа: %1, не одинаковых и с близкими неопределённостями; исходных результатов: %2.</translation>
    </message>
    <message>
        <source>⚠ They rise or fall (stable ones look so in 1 of 200 cases): the limits hold the trend. Choose a baseline without one.</source>
        <translation>⚠ Они растут или убывают (устойчивые выглядят так в 1 случае из 200): пределы включают тренд. Выберите исходные результаты без него.</translation>
    </message>
    <message>
        <source>⚠ Each resembles or opposes the one before (independent ones look so in 1 of 200 cases): alarms are not as rare as stated.</source>
        <translation>⚠ Каждый похож на предыдущий или противоположен ему (независимые выглядят так в 1 случае из 200): тревоги не так редки, как указано.</translation>
    </message>
    <message>
        <source>warnings: %1</source>
        <translation>предупреждения: %1</translation>
    </message>
    <message>
        <source>Date (UTC)</source>
        <translation>Дата (UTC)</translation>
    </message>
    <message>
        <source>Mean frequency f</source>
        <translation>Средняя частота f</translation>
    </message>
    <message>
        <source>Order of the results</source>
        <translation>Порядковый номер результата</translation>
    </message>
    <message>
        <source>No result with a date has a value of this parameter.</source>
        <translation>Ни у одного результата с датой нет значения этого параметра.</translation>
    </message>
    <message>
        <source>No result has a value of this parameter.</source>
        <translation>Ни у одного результата нет значения этого параметра.</translation>
    </message>
    <message>
        <source>passport ± 3 u</source>
        <translation>паспорт ± 3 u</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>центр</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>пределы</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>за пределами</translation>
    </message>
    <message>
        <source>Change from the one before</source>
        <translation>Изменение от предыдущего</translation>
    </message>
    <message>
        <source>moving range</source>
        <translation>скользящий размах</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>предел</translation>
    </message>
    <message>
        <source>Weighted average (EWMA)</source>
        <translation>Взвешенное среднее (EWMA)</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>СКО</translation>
    </message>
    <message>
        <source>This chart needs ten results of one gyro to set its limits.</source>
        <translation>Для пределов этой карты нужны десять результатов одного гироскопа.</translation>
    </message>
    <message>
        <source>average</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>Results in each step</source>
        <translation>Результатов в каждой ступени</translation>
    </message>
    <message>
        <source>A distribution needs two results with different values.</source>
        <translation>Для распределения нужны два результата с разными значениями.</translation>
    </message>
    <message>
        <source>results</source>
        <translation>результаты</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>нормальное</translation>
    </message>
    <message>
        <source>above the limit</source>
        <translation>выше предела</translation>
    </message>
    <message>
        <source>below the limit</source>
        <translation>ниже предела</translation>
    </message>
    <message>
        <source>a step from the one before</source>
        <translation>скачок от предыдущего</translation>
    </message>
    <message>
        <source>the average has moved</source>
        <translation>среднее сместилось</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) without a date are not shown; by order they are.</source>
        <translation>
            <numerusform>%n результат без даты не показан; по порядку он виден.</numerusform>
            <numerusform>%n результата без даты не показаны; по порядку они видны.</numerusform>
            <numerusform>%n результатов без даты не показаны; по порядку они видны.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The first %n result(s) set the limits.</source>
        <translation>
            <numerusform>Пределы заданы первым %n результатом.</numerusform>
            <numerusform>Пределы заданы первыми %n результатами.</numerusform>
            <numerusform>Пределы заданы первыми %n результатами.</numerusform>
        </translation>
    </message>
    <message>
        <source>f = %1 Hz</source>
        <translation>f = %1 Гц</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 В</translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) of all gyros.</source>
        <translation>
            <numerusform>%n результат всех гироскопов.</numerusform>
            <numerusform>%n результата всех гироскопов.</numerusform>
            <numerusform>%n результатов всех гироскопов.</numerusform>
        </translation>
    </message>
    <message>
        <source>Limits belong to one gyro: choose one for its control charts.</source>
        <translation>Пределы относятся к одному гироскопу: выберите его, чтобы увидеть контрольные карты.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>и ещё %n</numerusform>
            <numerusform>и ещё %n</numerusform>
            <numerusform>и ещё %n</numerusform>
        </translation>
    </message>
    <message>
        <source>limits of the gyro</source>
        <translation>пределы гироскопа</translation>
    </message>
    <message>
        <source>A change needs two results of one gyro in their order.</source>
        <translation>Для изменения нужны два результата одного гироскопа подряд.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Результаты</translation>
    </message>
    <message>
        <source>All gyros</source>
        <translation>Все гироскопы</translation>
    </message>
    <message>
        <source>History of a parameter</source>
        <translation>История параметра</translation>
    </message>
    <message>
        <source>Database: %1; %2, %3</source>
        <translation>База данных: %1; %2, %3</translation>
    </message>
    <message numerus="yes">
        <source>⚠ %n result(s) break the limits of the gyro.</source>
        <translation>
            <numerusform>⚠ %n результат вне пределов гироскопа.</numerusform>
            <numerusform>⚠ %n результата вне пределов гироскопа.</numerusform>
            <numerusform>⚠ %n результатов вне пределов гироскопа.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>None of %n result(s) is outside the control limits.</source>
        <translation>
            <numerusform>Ни один из %n результата не выходит за контрольные пределы.</numerusform>
            <numerusform>Ни один из %n результатов не выходит за контрольные пределы.</numerusform>
            <numerusform>Ни один из %n результатов не выходит за контрольные пределы.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n result(s) outside the control limits:</source>
        <translation>
            <numerusform>%n результат за контрольными пределами:</numerusform>
            <numerusform>%n результата за контрольными пределами:</numerusform>
            <numerusform>%n результатов за контрольными пределами:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LedgerRows</name>
    <message>
        <source>%1 of %2 windows</source>
        <translation>%1 из %2 окон</translation>
    </message>
    <message numerus="yes">
        <source>%n window(s), %1 flagged, in %2</source>
        <translation>
            <numerusform>%n окно, помечено %1, за %2</numerusform>
            <numerusform>%n окна, помечено %1, за %2</numerusform>
            <numerusform>%n окон, помечено %1, за %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Follows the settings while Live is on; Keep keeps an analysis as it is</source>
        <translation>Следует за настройками, пока включён «Автопересчёт»; «Закрепить» оставляет расчёт как есть</translation>
    </message>
    <message>
        <source>%1 (opening)</source>
        <translation>%1 (открывается)</translation>
    </message>
    <message>
        <source>Leakage of the window limits the mean frequency, by %1 Hz.</source>
        <translation>Среднюю частоту ограничивает утечка окна: %1 Гц.</translation>
    </message>
    <message numerus="yes">
        <source>The frequency of %n window(s) lies at the bound of the search; the mean&apos;s deviation allows for them.</source>
        <translation>
            <numerusform>Частота %n окна лежит на границе поиска; СКО среднего это учитывает.</numerusform>
            <numerusform>Частота %n окон лежит на границе поиска; СКО среднего это учитывает.</numerusform>
            <numerusform>Частота %n окон лежит на границе поиска; СКО среднего это учитывает.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>%1 Hz, from the file</source>
        <translation>%1 Гц, из файла</translation>
    </message>
    <message>
        <source>%1 Hz, from the time column</source>
        <translation>%1 Гц, по столбцу времени</translation>
    </message>
    <message>
        <source>%1 Hz, typed</source>
        <translation>%1 Гц, задана</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Частота дискретизации</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длительность</translation>
    </message>
    <message numerus="yes">
        <source>%1 s, %n sample(s)</source>
        <translation>
            <numerusform>%1 с, %n отсчёт</numerusform>
            <numerusform>%1 с, %n отсчёта</numerusform>
            <numerusform>%1 с, %n отсчётов</numerusform>
        </translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Начало</translation>
    </message>
    <message>
        <source>f₀</source>
        <translation>f₀</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Гц</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/с</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/с</translation>
    </message>
    <message>
        <source>no windows there</source>
        <translation>окон здесь нет</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>Набор: %1</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>Bent: %1; sd enlarged.</source>
        <translation>Изгиб больше шума: %1; СКО увеличены.</translation>
    </message>
    <message>
        <source>no windows there</source>
        <translation>окон здесь нет</translation>
    </message>
    <message>
        <source>The resonator of this recording beats at its split, %1 Hz</source>
        <translation>Резонатор этой записи бьётся с разночастотностью %1 Гц</translation>
    </message>
    <message>
        <source>Beat, Hz</source>
        <translation>Биение, Гц</translation>
    </message>
    <message>
        <source>Rate, per s</source>
        <translation>За секунду</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 с</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>СКО</translation>
    </message>
    <message>
        <source>A = %1 s</source>
        <translation>A = %1 с</translation>
    </message>
    <message>
        <source>B = %1 s</source>
        <translation>B = %1 с</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message numerus="yes">
        <source>%n window(s) without common samples</source>
        <translation>
            <numerusform>%n окно без общих отсчётов</numerusform>
            <numerusform>%n окна без общих отсчётов</numerusform>
            <numerusform>%n окон без общих отсчётов</numerusform>
        </translation>
    </message>
    <message>
        <source>Decay time of a_A: %1 s</source>
        <translation>Постоянная времени a_A: %1 с</translation>
    </message>
    <message>
        <source>The decay of a_A lies within its noise here.</source>
        <translation>Спад a_A здесь в пределах шума.</translation>
    </message>
    <message>
        <source>Drift of θ_A: %1 °/h</source>
        <translation>Дрейф θ_A: %1 °/ч</translation>
    </message>
    <message>
        <source>Drift of f: %1 Hz/s</source>
        <translation>Уход f: %1 Гц/с</translation>
    </message>
    <message>
        <source>%1: amplitude %2 %3, damping %4 1/s</source>
        <translation>%1: амплитуда %2 %3, затухание %4 1/с</translation>
    </message>
    <message>
        <source>Too few windows between the cursors.</source>
        <translation>Слишком мало окон между курсорами.</translation>
    </message>
    <message>
        <source>too few windows</source>
        <translation>мало окон</translation>
    </message>
    <message>
        <source>τ(%1) %2 s</source>
        <translation>τ(%1) %2 с</translation>
    </message>
    <message>
        <source>drift %1 °/h</source>
        <translation>дрейф %1 °/ч</translation>
    </message>
    <message>
        <source>sd enlarged: %1</source>
        <translation>СКО увеличены: %1</translation>
    </message>
    <message>
        <source>%1: no damped sinusoid, but the sum of two modes, which beat at %2 Hz</source>
        <translation>%1: не затухающая синусоида, а сумма двух мод, частота биений %2 Гц</translation>
    </message>
    <message>
        <source>nothing fits</source>
        <translation>не описано</translation>
    </message>
    <message>
        <source>two modes: %1</source>
        <translation>две моды: %1</translation>
    </message>
    <message>
        <source>Between the cursors neither a damped sinusoid of 1¼ to 100 periods nor the sum of two modes follows the windows within their noise. A beat that you see has another form or fewer periods: see the page Resonator.</source>
        <translation>Ни затухающая синусоида с числом периодов от 1¼ до 100, ни сумма двух мод не проходит между курсорами через окна в пределах их шума. Видимое биение имеет другую форму или меньше периодов: см. страницу «Резонатор».</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>The passport is that of the gyro %1, the recordings are of the gyro %2: their differences are no changes of one resonator.</source>
        <translation>Паспорт принадлежит гироскопу %1, записи сделаны с гироскопа %2: их различия — не изменения одного резонатора.</translation>
    </message>
    <message>
        <source>%2 cannot be &quot;%3&quot;: %4.</source>
        <translation>Недопустимое значение «%3» параметра %2: %4.</translation>
    </message>
    <message>
        <source>%1: the folder holds no recording. Choose one that does, or a measurement list.</source>
        <translation>%1: в папке нет записей. Выберите другую папку или список измерений.</translation>
    </message>
    <message>
        <source>%1: there is no such file. Check the name and the folder.</source>
        <translation>%1: такого файла нет. Проверьте имя и папку.</translation>
    </message>
    <message>
        <source>%1: no permission to read it. Change its permissions or copy it.</source>
        <translation>%1: нет права на чтение. Измените права доступа или скопируйте.</translation>
    </message>
    <message>
        <source>%1 is a folder, not a file. Name one file inside it.</source>
        <translation>%1 — папка, а не файл. Укажите файл внутри неё.</translation>
    </message>
    <message>
        <source>%1: the file is empty (0 bytes). Save or copy it again.</source>
        <translation>%1: файл пуст (0 байт). Сохраните или скопируйте его заново.</translation>
    </message>
    <message>
        <source>%1: reading failed: %2. Check the disk and copy the file again.</source>
        <translation>%1: ошибка чтения: %2. Проверьте диск и скопируйте файл заново.</translation>
    </message>
    <message>
        <source>%1: the program %2, which reads such files, cannot be started: %3. Install Vybeg again, with all of its programs.</source>
        <translation>%1: программа %2, которая читает такие файлы, не запускается: %3. Установите Vybeg заново, со всеми его программами.</translation>
    </message>
    <message>
        <source>%1: the %2 file is damaged: %3. Copy it again.</source>
        <translation>%1: файл %2 повреждён: %3. Скопируйте его заново.</translation>
    </message>
    <message>
        <source>%1, line %2, column %3: &quot;%4&quot; is not a number. Correct it; a missing sample, but no time, may be written as nan.</source>
        <translation>%1, строка %2, столбец %3: «%4» — не число. Исправьте его; потерянный отсчёт, но не время, можно записать как nan.</translation>
    </message>
    <message>
        <source>%1: no line with two or more numbers. The file needs one column for each pick-off.</source>
        <translation>%1: нет ни одной строки с двумя и более числами. Нужен столбец на каждый измерительный канал.</translation>
    </message>
    <message>
        <source>%1, line %2: the time %3 does not follow %4. The time column must rise.</source>
        <translation>%1, строка %2: время %3 не следует за %4. Столбец времени должен возрастать.</translation>
    </message>
    <message>
        <source>%1 holds %2 sample(s), and at least %3 are needed.</source>
        <translation>%1: отсчётов %2, а нужно не менее %3.</translation>
    </message>
    <message>
        <source>%1 changed while it was read: its size or the time of its last change is another. Wait until it is complete, and open it again.</source>
        <translation>%1: файл изменился во время чтения (размер или время последнего изменения). Дождитесь окончания записи и откройте его снова.</translation>
    </message>
    <message>
        <source>%1: the window of %2 samples is longer than the %3 samples to analyse. Choose a shorter window or a longer range.</source>
        <translation>%1: окно из %2 отсчётов длиннее обрабатываемого участка (отсчётов: %3). Выберите более короткое окно или более длинный участок.</translation>
    </message>
    <message>
        <source>%1: the window of %2 samples is too short; at this carrier it needs at least %3 (5 samples, and three quarters of a period of the carrier and of its distance from half the sample rate).</source>
        <translation>%1: окно из %2 отсчётов слишком короткое; при этой несущей частоте нужно не менее %3 (5 отсчётов и три четверти периода — как несущей, так и её расстояния до половины частоты дискретизации).</translation>
    </message>
    <message>
        <source>%1: nothing lies between %2 s and %3 s; the recording is %4 s long.</source>
        <translation>%1: между %2 с и %3 с ничего нет; длительность записи %4 с.</translation>
    </message>
    <message>
        <source>%1: the carrier of %2 Hz is not below half the sample rate, %3 Hz. Check the carrier and the rate.</source>
        <translation>%1: несущая частота %2 Гц не ниже половины частоты дискретизации, %3 Гц. Проверьте обе частоты.</translation>
    </message>
    <message>
        <source>%1: no line stands out of the spectrum within %3 Hz of the carrier given, %2 Hz. Give a nearer one, or leave it out so that it is looked for.</source>
        <translation>%1: в пределах %3 Гц от заданной несущей, %2 Гц, в спектре нет ни одной линии. Задайте частоту точнее или не задавайте её: программа найдёт несущую сама.</translation>
    </message>
    <message>
        <source>%1: the band from %2 Hz to %3 Hz is impossible; it must rise and lie between 0 and half the sample rate, %4 Hz.</source>
        <translation>%1: полоса от %2 Гц до %3 Гц невозможна; она должна возрастать и лежать между 0 и половиной частоты дискретизации, %4 Гц.</translation>
    </message>
    <message>
        <source>%1: the filter needs %2 samples at each end, and the recording has only %3. Choose a wider band or a longer recording.</source>
        <translation>%1: фильтру нужно %2 отсчётов на каждом конце, а в записи их всего %3. Выберите более широкую полосу или более длинную запись.</translation>
    </message>
    <message>
        <source>%1: every sample of the range is missing (NaN).</source>
        <translation>%1: на участке нет ни одного годного отсчёта (все NaN).</translation>
    </message>
    <message>
        <source>This decay cannot be simulated: %2.</source>
        <translation>Такой выбег смоделировать нельзя: %2.</translation>
    </message>
    <message>
        <source>%1: the window of %2 samples is too short for the resonator&apos;s fit; at this carrier it needs at least %3 (16 samples and two periods).</source>
        <translation>%1: окно из %2 отсчётов слишком коротко для подгонки резонатора; при такой несущей нужно не меньше %3 (16 отсчётов и два периода).</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same samples (SHA-256): a recording that is counted twice is no new evidence. Name each recording once.</source>
        <translation>%1 и %2 содержат одни и те же отсчёты (SHA-256): запись, учтённая дважды, новых данных не даёт. Укажите каждую запись один раз.</translation>
    </message>
    <message>
        <source>%1: channel %2 has no samples in the range: every one is missing (NaN). Choose other channels or another range.</source>
        <translation>%1: в канале %2 на этом участке нет отсчётов: все пропущены (NaN). Выберите другие каналы или другой участок.</translation>
    </message>
    <message>
        <source>There is not enough memory. Choose a shorter range, or end other programs.</source>
        <translation>Не хватает памяти. Выберите участок короче или закройте другие программы.</translation>
    </message>
    <message>
        <source>A fault of Vybeg stopped this work (%2). Please report it, with the recording and the settings; all else goes on.</source>
        <translation>Работа прервана из-за ошибки в программе Vybeg (%2). Сообщите о ней, приложив запись и параметры; всё остальное продолжает работать.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Nothing was changed there.</source>
        <translation>Не удалось записать %1: %2. Прежнее содержимое не изменено.</translation>
    </message>
    <message>
        <source>%1: the ending &quot;%2&quot; is none of those that can be written here: %3.</source>
        <translation>%1: окончание «%2» не из тех, с которыми здесь можно записать файл: %3.</translation>
    </message>
    <message>
        <source>%1 is one of the open files, and stays as it is. Choose another name.</source>
        <translation>%1 — один из открытых файлов; он не изменён. Выберите другое имя.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. What has gone out there is incomplete.</source>
        <translation>Не удалось записать %1: %2. Уже переданное туда неполно.</translation>
    </message>
    <message>
        <source>Interrupted; what has gone out to %1 is incomplete.</source>
        <translation>Прервано; переданное в %1 неполно.</translation>
    </message>
    <message>
        <source>Interrupted; nothing was written.</source>
        <translation>Прервано; ничего не записано.</translation>
    </message>
    <message>
        <source>The time column is uneven, by up to %1 s (%2 samples); the signals were resampled to a uniform grid by local cubic interpolation.</source>
        <translation>Столбец времени неравномерен, отклонение до %1 с (отсчётов: %2); сигналы пересчитаны на равномерную сетку локальной кубической интерполяцией.</translation>
    </message>
    <message>
        <source>%1 samples are missing at %2 s; windows over them are flagged.</source>
        <translation>Пропущено отсчётов: %1, момент %2 с; окна с ними помечены.</translation>
    </message>
    <message>
        <source>%1 samples are NaN or infinite; windows over them are flagged.</source>
        <translation>Отсчётов NaN или бесконечных: %1; окна с ними помечены.</translation>
    </message>
    <message>
        <source>The file ends early: its header promises %1 frames, %2 are there. Those are used.</source>
        <translation>Файл обрывается: в заголовке указано отсчётов %1, есть %2. Обработаны имеющиеся.</translation>
    </message>
    <message>
        <source>The file ends within a row, which is left out.</source>
        <translation>Файл обрывается внутри строки; она пропущена.</translation>
    </message>
    <message>
        <source>The file is still being written, was never closed or has been cut off: nothing in it says how many frames there are to be. The %1 that are there are used.</source>
        <translation>Файл ещё записывается, не был закрыт или обрезан: сколько в нём должно быть отсчётов, неизвестно. Обработаны имеющиеся: %1.</translation>
    </message>
    <message>
        <source>The channels differ in length: %1 has %2 samples, %3 has %4. Both are counted from their first sample, and the end of the longer one is left out.</source>
        <translation>Каналы разной длины: в канале %1 отсчётов %2, в канале %3 отсчётов %4. Оба отсчитываются от первого отсчёта, конец более длинного отброшен.</translation>
    </message>
    <message>
        <source>The band-pass takes %1 s at each end for its transient; those windows are flagged.</source>
        <translation>Переходный процесс полосового фильтра занимает %1 с на каждом конце; эти окна помечены.</translation>
    </message>
    <message>
        <source>This algorithm needs %1 samples on both sides of a window; windows without them are flagged.</source>
        <translation>Этому алгоритму нужно %1 отсчётов по обе стороны окна; окна без них помечены.</translation>
    </message>
    <message>
        <source>%1 of %2 windows did not converge; they are flagged.</source>
        <translation>Окон без сходимости: %1 из %2; они помечены.</translation>
    </message>
    <message>
        <source>In %1 of %2 windows the algorithm is off by more than one standard deviation, by leakage; they are flagged. A window of whole half-periods (Snap) makes it smallest; conjugate gradient and maximum likelihood have none.</source>
        <translation>Окон, в которых из-за утечки ошибка алгоритма больше одного СКО: %1 из %2; они помечены. Меньше всего утечка в окне из целых полупериодов («К полупериодам»); у сопряжённых градиентов и максимального правдоподобия её нет.</translation>
    </message>
    <message>
        <source>In %1 of %2 windows the wave moves inside the window, or turns too far from one window to the next; they are flagged. Choose a shorter window or a smaller step.</source>
        <translation>Окон, в которых волна заметно меняется за время окна или слишком далеко поворачивается от окна к окну: %1 из %2; они помечены. Возьмите более короткое окно или меньший шаг.</translation>
    </message>
    <message>
        <source>%1 header or comment lines were passed over.</source>
        <translation>Пропущено строк заголовка и комментариев: %1.</translation>
    </message>
    <message>
        <source>%1: this %2 file holds %3, which is not read here. Export the recording as WAV or CSV.</source>
        <translation>%1: файл %2 содержит %3, здесь это не читается. Сохраните запись в WAV или CSV.</translation>
    </message>
    <message>
        <source>%1 is not a passport that can be read: %2.</source>
        <translation>%1 — не паспорт, который можно прочитать: %2.</translation>
    </message>
    <message>
        <source>%1: a passport of schema %2; this program knows schemas up to %3. Use the program that wrote it, or a newer one.</source>
        <translation>%1: паспорт схемы %2; эта программа знает схемы до %3. Возьмите программу, которая его записала, или более новую.</translation>
    </message>
    <message>
        <source>Channel %1: %2 samples lie beyond its range and are missing. Record with a larger range.</source>
        <translation>Канал %1: отсчётов за пределами шкалы: %2, они пропущены. Запишите с большим пределом измерения.</translation>
    </message>
    <message>
        <source>Channel %1 is in %2 in the file; it was converted to %3, the unit of channel C.</source>
        <translation>Канал %1 записан в файле в %2; пересчитан в %3, единицу канала C.</translation>
    </message>
    <message>
        <source>Channel %1 is clipped: %2 samples at its rail, %3. Windows over them are flagged.</source>
        <translation>Канал %1 ограничен: на пределе шкалы (%3) отсчётов: %2. Окна с ними помечены.</translation>
    </message>
    <message>
        <source>The angle of %1 jumps by %2 degrees at %3 s (places: %4). A false row is left out; where the controller&apos;s reference was set anew, the harmonics mix two angles: give each part as a log of its own.</source>
        <translation>Угол в %1 скачком меняется на %2° при %3 с (мест: %4). Ложная строка отброшена; если опора регулятора установлена заново, гармоники смешивают два угла: дайте каждую часть отдельным журналом.</translation>
    </message>
    <message>
        <source>The angle of %1 is written in steps of %2 degrees, coarse beside its turn from row to row, %3 degrees: the harmonics may be wrong by several of their deviations. Write more digits.</source>
        <translation>Угол в %1 записан с шагом %2°, грубым рядом с его поворотом от строки к строке, %3°: гармоники могут ошибаться на несколько СКО. Записывайте больше цифр.</translation>
    </message>
    <message>
        <source>By their own times the sample rate of channel D is %1 ppm above that of channel C; D was interpolated to C&apos;s times. Where both have one clock, their times are wrong, and so is the phase between the channels.</source>
        <translation>По собственным временам каналов частота отсчётов D на %1 ppm выше, чем у C; D интерполирован на времена C. Если часы у каналов общие, то времена неверны, а с ними и фаза между каналами.</translation>
    </message>
    <message>
        <source>Neither channel moves for 16 samples and a period of the carrier, or longer, in %1 place(s), %2 samples in all, the first at %3 s: lost samples that were filled, or a wave below one bit. Windows over them are flagged.</source>
        <translation>Оба канала неподвижны 16 отсчётов и период несущей или дольше: мест %1, отсчётов %2, первое при %3 с. Это заполненные потерянные отсчёты или волна слабее одного разряда. Окна, содержащие эти места, отмечены.</translation>
    </message>
    <message>
        <source>In %1 places, the first at %2 s, both channels repeat a sample or are zero, off the wave around them: lost samples that were filled. The decay is wrong where their number grows or falls. Record without losses.</source>
        <translation>В %1 местах, первое при %2 с, оба канала повторяют отсчёт или равны нулю, хотя волна вокруг иная: потерянные отсчёты заполнены. Если их число растёт или падает, затухание неверно. Записывайте без потерь.</translation>
    </message>
    <message>
        <source>Samples lost: %1 at %2 s. Windows over the place are flagged.</source>
        <translation>Потеряно отсчётов: %1, на %2 с. Окна, содержащие это место, помечены.</translation>
    </message>
    <message>
        <source>Samples doubled: %1 at %2 s. Windows over the place are flagged.</source>
        <translation>Повторено отсчётов: %1, на %2 с. Окна, содержащие это место, помечены.</translation>
    </message>
    <message>
        <source>A step of %1 rad in the phase of both channels at %2 s: samples were lost or doubled. The phase shows their number only modulo the period: doubled %3, lost %4, or more than 100. Windows over the place are flagged.</source>
        <translation>Скачок фазы на %1 рад в обоих каналах, на %2 с: отсчёты потеряны или повторены. Фаза показывает их число только с точностью до периода: повторено %3, потеряно %4 либо больше 100. Окна, содержащие это место, помечены.</translation>
    </message>
    <message>
        <source>Further places where samples were lost or doubled: %1.</source>
        <translation>Отсчёты потеряны или повторены ещё в стольких местах: %1.</translation>
    </message>
    <message>
        <source>Channel %1 is constant: it holds no signal.</source>
        <translation>Канал %1 постоянен: сигнала в нём нет.</translation>
    </message>
    <message>
        <source>Channels C and D hold the same %1 samples: they are one signal, and the wave of two channels is not in it. Choose the other channel{ (--channels)}.</source>
        <translation>В каналах C и D одни и те же отсчёты (%1): это один сигнал, и волны двух каналов в нём нет. Выберите другой канал{ (--channels)}.</translation>
    </message>
    <message>
        <source>Channel %1 stays within %2 levels of the converter: its signal is below one bit.</source>
        <translation>Канал %1 не выходит за %2 уровня преобразователя: сигнал меньше одного разряда.</translation>
    </message>
    <message>
        <source>Lost samples made gaps, as asked for: %1; places: %2. Windows over them have no values.</source>
        <translation>По запросу на месте потерянных отсчётов сделаны пропуски (отсчётов: %1, мест: %2); окна с ними без значений.</translation>
    </message>
    <message>
        <source>Lost samples counted in the time behind them, so that the phase runs on: %1; places: %2.</source>
        <translation>Потерянные отсчёты (%1, мест: %2) учтены во времени после них, так что фаза идёт дальше.</translation>
    </message>
    <message>
        <source>Places where an unknown number of samples was lost or doubled: %1. The phase after each is a parameter of its own; time moves by the smallest possible number.</source>
        <translation>Мест, где потеряно или повторено неизвестное число отсчётов: %1. Фаза после каждого — отдельный параметр; время сдвинуто на наименьшее возможное число.</translation>
    </message>
    <message>
        <source>The first %1 s are left out of the fit: a strike, or what a band-pass makes of the beginning, is no free decay.</source>
        <translation>Первые %1 с в подгонку не взяты: удар или то, что полосовой фильтр делает с началом записи, — не свободный выбег.</translation>
    </message>
    <message>
        <source>The carrier given is %1 Hz, and the signal is at %2 Hz: that is used.</source>
        <translation>Задана несущая %1 Гц, а сигнал находится на %2 Гц: использована эта частота.</translation>
    </message>
    <message>
        <source>%1: %2 lines are to be skipped, and the file has only %3.</source>
        <translation>%1: нужно пропустить строк: %2, а в файле их всего %3.</translation>
    </message>
    <message>
        <source>%1: read as text with %2, no line from %3 on has two or more numbers; that line reads &quot;%4&quot;. Choose another delimiter, decimal sign or first line.</source>
        <translation>%1: если читать как текст с параметрами %2, то начиная со строки %3 нет ни одной строки, где два числа или больше; там стоит «%4». Выберите другой разделитель, десятичный знак или первую строку.</translation>
    </message>
    <message>
        <source>%1: there is no column %2 to be the time; the file has %3.</source>
        <translation>%1: нет столбца %2, который был бы временем; столбцов в файле: %3.</translation>
    </message>
    <message>
        <source>%1: the resonator needs %3 windows without faults, and there are %2. Use a longer recording or shorter windows.</source>
        <translation>%1: для резонатора нужно не меньше %3 окон без дефектов, а их %2. Возьмите запись длиннее или окна короче.</translation>
    </message>
    <message>
        <source>%1: the window of %2 samples is too long for the beat between the lines at %3 Hz and %4 Hz. Use at most %5 samples, or leave the window out.</source>
        <translation>%1: окно в %2 отсчётов слишком длинное для биений между линиями %3 Гц и %4 Гц. Возьмите не больше %5 отсчётов или не задавайте окно.</translation>
    </message>
    <message>
        <source>The resonator cannot be fitted to %1: %2.</source>
        <translation>Не удалось подогнать резонатор к %1: %2.</translation>
    </message>
    <message>
        <source>%1: %2 of phasors is less than four times the split of %3, so that the motion may be folded. Log them at a higher rate.</source>
        <translation>%1: частота записи комплексных амплитуд %2 меньше четырёх разночастотностей (%3), движение может быть искажено наложением частот. Записывайте чаще.</translation>
    </message>
    <message>
        <source>Recording %1: the frequency drifts by %2 Hz per second (standard deviation %3); the drift is fitted, and Q is free of it.</source>
        <translation>Запись %1: частота уходит на %2 Гц в секунду (СКО %3); уход включён в подгонку, и добротность от него не зависит.</translation>
    </message>
    <message>
        <source>The frequency depends on the amplitude: %1 Hz per squared recording unit (standard deviation %2); this is fitted.</source>
        <translation>Частота зависит от амплитуды: %1 Гц на квадрат единицы записи (СКО %2); это включено в подгонку.</translation>
    </message>
    <message>
        <source>Recording %1: Q from the envelope, %2, and from the coherent fit, %3, differ by more than four standard deviations: the motion is not that of a resonator with constant parameters.</source>
        <translation>Запись %1: добротность по огибающей, %2, и по когерентной подгонке, %3, расходятся больше чем на четыре СКО: это не движение резонатора с постоянными параметрами.</translation>
    </message>
    <message>
        <source>The residual is above the noise of the windows (chi square per degree of freedom %1); the standard deviations are enlarged to match.</source>
        <translation>Невязка больше шума окон (хи-квадрат на степень свободы %1); СКО соответственно увеличены.</translation>
    </message>
    <message>
        <source>The fit of the resonator stopped before it converged: its values are refused.</source>
        <translation>Подгонка резонатора остановилась, не сойдясь: её значения не приводятся.</translation>
    </message>
    <message>
        <source>The damping was seen in one direction only: the recording&apos;s own decay time is given, not the resonator&apos;s.</source>
        <translation>Затухание наблюдалось только в одном направлении: приводится время затухания самой записи, а не резонатора.</translation>
    </message>
    <message>
        <source>The channels are no calibrated pair of pick-offs (%1): the free model gives the modes, and the resonator has no axes. If they are calibrated, choose the structured model.</source>
        <translation>Каналы — не откалиброванная пара датчиков (%1): свободная модель даёт моды, осей у резонатора нет. Если пара откалибрована, выберите модель с калиброванными датчиками.</translation>
    </message>
    <message>
        <source>The residual is below the noise of the windows (chi square per degree of freedom %1): the standard deviations are too large.</source>
        <translation>Невязка меньше шума окон (хи-квадрат на степень свободы %1): СКО завышены.</translation>
    </message>
    <message>
        <source>The residual is not white (chi square per degree of freedom %1); the standard deviations follow its spectrum.</source>
        <translation>Невязка не белая (хи-квадрат на степень свободы %1); СКО взяты по её спектру.</translation>
    </message>
    <message>
        <source>The noise about the carrier is as narrow as the residual can show. Noise narrower than %1 Hz looks like the wave itself: the standard deviations may be too small. Record longer, or repeat the recording.</source>
        <translation>Шум около несущей настолько узок, насколько это видно по невязке. Шум уже %1 Гц неотличим от самой волны: СКО могут быть занижены. Нужна более длинная запись или повторная.</translation>
    </message>
    <message>
        <source>The quadrature of the recordings at their starts follows the angle, as an error of the channels makes it: %1, about %2. Split, axes and rotation may be off by more than their uncertainties. Measure it and correct the signals{ (a delay by --delay), or state its tolerance (--tolerance)|, or state its tolerance}.</source>
        <translation>Квадратура записей в их начале следует за углом, как при ошибке каналов: %1, около %2. Разночастотность, оси и вращение могут быть ошибочны больше своих неопределённостей. Измерьте её и исправьте сигналы или задайте её допуск.</translation>
    </message>
    <message>
        <source>The waves turn by %1, faster than the Earth. Where the base turns, that is right. Where it stands still, it is an error of the channels, %2 of about %3, and split and axes are off, too: measure it and correct the signals{ (--delay)}.</source>
        <translation>Волны поворачиваются со скоростью %1, быстрее Земли. Если основание вращается, так и есть. Если оно неподвижно, это ошибка каналов: %2, около %3; тогда ошибочны и разночастотность, и оси: измерьте её и исправьте сигналы.</translation>
    </message>
    <message>
        <source>The recordings need a channel error far beyond its tolerance: %1 of %2, %3 tolerances. The tolerance is too small, or the motion is not that of the model: the numbers may be off by more than their uncertainties.</source>
        <translation>Для записей нужна ошибка каналов далеко за её допуском: %1, равная %2, то есть %3 допуска. Допуск слишком мал, или движение не соответствует модели: числа могут быть ошибочны больше своих неопределённостей.</translation>
    </message>
    <message>
        <source>The damping anisotropy, %1 1/s, reaches the greatest value of a passive resonator, 2/tau = %2 1/s: one mode hardly decays. The motion may not be that of the model, and the numbers may be off by more than their uncertainties.</source>
        <translation>Разнодобротность, %1 1/с, достигает наибольшего значения пассивного резонатора, 2/tau = %2 1/с: одна мода почти не затухает. Движение может не соответствовать модели, и числа могут быть ошибочны больше своих неопределённостей.</translation>
    </message>
    <message>
        <source>The residual is that of springs that follow the amplitude differently along the axes (about %1 Hz at the largest amplitude), which the model does not hold: split, axes and rotation may be off by more than their uncertainties. Record smaller amplitudes.</source>
        <translation>Невязка такая, как при жёсткости, которая вдоль осей зависит от амплитуды по-разному (около %1 Гц при наибольшей амплитуде); в модели этого нет: разночастотность, оси и вращение могут быть ошибочны больше своих неопределённостей. Запишите меньшие амплитуды.</translation>
    </message>
    <message>
        <source>The residual is that of pick-offs whose gain follows the amplitude: by about %1 % in channel C and %2 % in D at the largest amplitude, which the model does not hold. Split, damping, axes and rotation may be off by more than their deviations. Linearise the channels, or record smaller amplitudes.</source>
        <translation>Невязка такая, как у датчиков, усиление которых зависит от амплитуды: примерно на %1 % в канале C и на %2 % в D при наибольшей амплитуде; в модели этого нет. Разночастотность, затухание, оси и вращение могут быть ошибочны больше своих СКО. Линеаризуйте каналы или запишите меньшие амплитуды.</translation>
    </message>
    <message>
        <source>%1: the phase of both channels steps by %2 rad at %3 s; samples are lost or doubled there. The fit leaves the phase open at that place.</source>
        <translation>%1: фаза обоих каналов делает скачок на %2 рад в %3 с; там потеряны или повторены отсчёты. Подгонка оставляет фазу в этом месте свободной.</translation>
    </message>
    <message>
        <source>%1: the gain of channel C changes by %2 % and that of D by %3 % at %4 s, as where %5. The fit leaves both gains open at that place; {--from|the start of the range} can leave out what is before it.</source>
        <translation>%1: усиление канала C меняется на %2 %, а канала D на %3 % в %4 с, как %5. Подгонка оставляет оба усиления в этом месте свободными; то, что раньше, можно исключить началом диапазона.</translation>
    </message>
    <message>
        <source>%1: the wave changes by %2 % of itself at %3 s, as by a knock or as a drive ends. The fit leaves the wave open at that place.</source>
        <translation>%1: волна меняется на %2 % своей величины в %3 с, как от толчка или конца возбуждения. Подгонка оставляет волну в этом месте свободной.</translation>
    </message>
    <message>
        <source>%1: the signal is disturbed at %2 s; the fit leaves %3 s out.</source>
        <translation>%1: сигнал возмущён в %2 с; подгонка не учитывает %3 с.</translation>
    </message>
    <message>
        <source>The motion is not that of the model: the residual is no stationary noise, or the two halves of the recordings disagree by more than noise explains. The standard deviations contain the disagreement; fit parts of the recordings to see which one differs.</source>
        <translation>Движение не соответствует модели: невязка не является стационарным шумом, или две половины записей расходятся сильнее, чем объясняет шум. СКО включают это расхождение; подгоните части записей, чтобы увидеть, какая из них отличается.</translation>
    </message>
    <message>
        <source>%1 has no effect: %2.</source>
        <translation>%1 ни на что не влияет: %2.</translation>
    </message>
    <message>
        <source>Channel %1 is in %2 and channel %3 in %4, units without a known ratio: amplitudes and angles are wrong. Choose channels of one unit{ with --channels, or give the gain ratio with --kappa|, or give the gain ratio}.</source>
        <translation>Канал %1 записан в %2, канал %3 — в %4; отношение этих единиц неизвестно, амплитуды и углы будут неверны. Выберите каналы с одной единицей или задайте отношение коэффициентов передачи.</translation>
    </message>
    <message>
        <source>The times are in &apos;%1&apos;, an unknown unit, and are read as seconds. Choose their unit{ with --time-unit, or their rate with --time-column none and --rate|, or open the file without a time column and give the sample rate}.</source>
        <translation>Единица времени «%1» неизвестна, время прочитано как секунды. Укажите единицу или откройте файл без столбца времени и задайте частоту дискретизации.</translation>
    </message>
    <message>
        <source>Channel %1 has an offset of %2, %3 % of the amplitude. The calibration removes it{ (--offset auto)}.</source>
        <translation>В канале %1 постоянное смещение %2, %3 % амплитуды. Его убирает калибровка.</translation>
    </message>
    <message>
        <source>A line of the mains at %1 Hz, %2 % of the carrier. A band-pass removes it{ (--filter)}.</source>
        <translation>Сетевая наводка на %1 Гц, %2 % несущей. Её убирает полосовой фильтр.</translation>
    </message>
    <message>
        <source>The first %1 s do not decay like the rest of the recording. The range can leave them out{ (--from)}.</source>
        <translation>Первые %1 с затухают не так, как остальная запись. Их можно исключить диапазоном.</translation>
    </message>
    <message>
        <source>The residual is that of a frequency that settles by about %1 Hz in %2 s, which the model does not hold: the resonator&apos;s numbers may be off by more than their deviations. Leave the first seconds out {(--from)|of the range}.</source>
        <translation>Невязка такая, как при установлении частоты примерно на %1 Гц за %2 с; в модели этого нет: параметры резонатора могут быть ошибочны больше своих СКО. Исключите первые секунды из диапазона.</translation>
    </message>
    <message>
        <source>The residual holds a line at about %1 Hz, %2 % of the wave: %3, which the model does not hold. Split, axes, rotation and the wave&apos;s own numbers may be off by more than their deviations. A narrower band-pass{ (--filter)} %4.</source>
        <translation>В невязке линия около %1 Гц, %2 % волны: %3; в модели этого нет. Разночастотность, оси, вращение и числа самой волны могут быть ошибочны больше своих СКО. Более узкий полосовой фильтр %4.</translation>
    </message>
    <message>
        <source>The residual is that of an error of the channels that is taken as zero: %1, about %2. Calibrate it, or {tell its tolerance (--tolerance)|state its tolerance}.</source>
        <translation>Невязка такая, как при ошибке каналов, принятой за ноль: %1, около %2. Откалибруйте её или задайте её допуск.</translation>
    </message>
    <message>
        <source>%1: there is no channel %2; the file has %3. Choose other channels{ with --channels}.</source>
        <translation>%1: канала %2 нет, в файле их %3. Выберите другие каналы.</translation>
    </message>
    <message>
        <source>%1: the file does not tell its sample rate. Give it{ with --rate}, in Hz.</source>
        <translation>%1: в файле не указана частота дискретизации. Задайте её в герцах.</translation>
    </message>
    <message>
        <source>%1: there is no variable &quot;%2&quot; to read; the file has %3. Choose others{ with --variables}.</source>
        <translation>%1: переменной «%2» нет; в файле есть %3. Выберите другие.</translation>
    </message>
    <message>
        <source>%1: several variables may be the recording: %2. Choose among them{ with --variables}.</source>
        <translation>%1: записью могут быть несколько переменных: %2. Выберите нужные.</translation>
    </message>
    <message>
        <source>%1: both channels are constant: they hold no signal. Choose other channels{ (--channels)} or another range{ (--from, --to)}.</source>
        <translation>%1: оба канала постоянны: сигнала в них нет. Выберите другие каналы{ (--channels)} или другой участок{ (--from, --to)}.</translation>
    </message>
    <message>
        <source>%1: no carrier stands out of the spectrum. Give {it with --f0, or the band to look in with --band|its frequency, or the band to look in}.</source>
        <translation>%1: несущая не выделяется в спектре. Задайте её частоту или полосу поиска.</translation>
    </message>
    <message>
        <source>%1: every window holds clipped samples (channel %2). Record with a lower gain, begin the range where the wave is weaker{ (--from)}, or shorten the window.</source>
        <translation>%1: в каждом окне есть ограниченные отсчёты (канал %2). Уменьшите усиление при записи, начните участок там, где волна слабее, или возьмите окно короче.</translation>
    </message>
    <message>
        <source>%1: the lines at %2 Hz and %3 Hz beat too fast for windows of %4 samples, the shortest at this carrier. Keep one pair of modes with {--filter|the band-pass}.</source>
        <translation>%1: биения линий %2 Гц и %3 Гц слишком быстры для окон в %4 отсчётов, самых коротких при этой несущей. Оставьте одну пару мод полосовым фильтром.</translation>
    </message>
    <message>
        <source>%1: the band from %2 Hz to %3 Hz is too narrow for the search for the carrier; at this length it needs at least %4 Hz. Give the {carrier with --f0|frequency of the carrier}, or a wider band.</source>
        <translation>%1: полоса от %2 до %3 Гц слишком узка для поиска несущей; при такой длине нужно не меньше %4 Гц. Задайте частоту несущей или более широкую полосу.</translation>
    </message>
    <message>
        <source>The system starts no more threads. Raise the limit of processes{, or give a smaller number with --threads}.</source>
        <translation>Система больше не запускает потоков. Увеличьте ограничение на число процессов.</translation>
    </message>
    <message>
        <source>%1: neither an audio file nor a table of numbers. Save the recording as WAV or CSV, or give the layout of raw samples {with --raw|under Import}.</source>
        <translation>%1: это не звуковой файл и не таблица чисел. Сохраните запись в WAV или CSV либо задайте расположение отсчётов через «Импорт».</translation>
    </message>
    <message>
        <source>Channel %1 is in %2 and channel %3 states no unit: both are taken to be in the same one.</source>
        <translation>Канал %1 записан в %2, у канала %3 единица не указана; принято, что она та же.</translation>
    </message>
    <message>
        <source>%1: commas separate both columns and decimals, as in &quot;%2&quot;. Export the table with semicolons or tabs between its columns, or with decimal points.</source>
        <translation>%1: запятые разделяют и столбцы, и десятичные знаки, например: «%2». Сохраните таблицу с точкой с запятой или табуляцией между столбцами либо с десятичной точкой.</translation>
    </message>
    <message>
        <source>%1: separators of thousands seem to stand within the numbers, as in &quot;%2&quot;. Export the table without them.</source>
        <translation>%1: похоже, внутри чисел стоят разделители тысяч, например: «%2». Сохраните таблицу без них.</translation>
    </message>
    <message>
        <source>%1: the file has several segments: its header begins again in line %2. Save each segment as a file of its own.</source>
        <translation>%1: в файле несколько сегментов: в строке %2 снова начинается заголовок. Сохраните каждый сегмент отдельным файлом.</translation>
    </message>
    <message>
        <source>%1: channel %2 rises by equal steps: it holds times or numbers of rows, no signal. Choose other channels{ with --channels}.</source>
        <translation>%1: канал %2 растёт равными шагами: это время или номера строк, а не сигнал. Выберите другие каналы.</translation>
    </message>
    <message>
        <source>%1, line %2, column &quot;%3&quot;: %4.</source>
        <translation>%1, строка %2, столбец «%3»: %4.</translation>
    </message>
    <message>
        <source>%1: the recordings differ in %2 (%3 and %4), and the fit has one value for all. Put them into different sets.</source>
        <translation>%1: у записей различается %2 (%3 и %4), а модель предполагает одно значение для всех. Разнесите их по разным наборам.</translation>
    </message>
    <message>
        <source>Interrupted; %2 of %3 sets are done.{ Continue with --resume.}</source>
        <translation>Прервано; готово наборов: %2 из %3.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; of the list is kept as it is and changes nothing. Did you mean &quot;%2&quot;? Rename it then.</source>
        <translation>Столбец «%1» списка сохраняется как есть и ничего не меняет. Имеется в виду «%2»? Тогда переименуйте его.</translation>
    </message>
    <message>
        <source>The table&apos;s field &quot;%1&quot; (%2) begins as a formula does, and a table program that opens the results runs it.</source>
        <translation>Поле таблицы «%1» (%2) начинается как формула, и табличная программа, открыв результаты, её выполнит.</translation>
    </message>
    <message>
        <source>%1 holds %2 finished rows of an interrupted batch. All sets are computed again; the rows stay until the table is written, and a resumed batch takes them.</source>
        <translation>В %1 — готовые строки прерванной пакетной обработки (%2). Все наборы вычисляются заново; строки остаются, пока таблица не записана, и их берёт продолженная обработка.</translation>
    </message>
    <message>
        <source>Channel C is read from &quot;%1&quot;, channel D from &quot;%2&quot;. Exchange the channels if their names are right.</source>
        <translation>Канал C читается из «%1», канал D — из «%2». Поменяйте каналы местами, если имена верны.</translation>
    </message>
    <message>
        <source>%1 holds %2 finished rows that this batch cannot take: their sets, recordings, settings, limits or columns are others.</source>
        <translation>В %1 — готовые строки (%2), которые эта обработка не может взять: их наборы, записи, настройки, пределы или столбцы другие.</translation>
    </message>
    <message>
        <source>The limits are not kept by %1 of %3 sets; %2 are undecided.</source>
        <translation>Допускам не соответствуют наборы: %1, не решено: %2, всего: %3.</translation>
    </message>
    <message>
        <source>Nothing is judged in %1 of %2 sets: the table of limits has none for their type of gyro.</source>
        <translation>Наборов без оценки: %1 из %2: в таблице нет допусков для их типа гироскопа.</translation>
    </message>
    <message>
        <source>%1 is in use by another program. The batch waits for it, up to %2 s.</source>
        <translation>%1 занят другой программой. Пакетная обработка ждёт его, не дольше %2 с.</translation>
    </message>
    <message>
        <source>The database holds the result of %1 alone: %2 has the same recordings and settings.</source>
        <translation>В базе только результат %1: у %2 те же записи и параметры.</translation>
    </message>
    <message>
        <source>The list has several sets. Choose one by %2: %3.</source>
        <translation>В списке несколько наборов. Выберите один параметром %2: %3.</translation>
    </message>
    <message>
        <source>%1 does not fit the other recordings of the set: %2. The resonator is that of the others.</source>
        <translation>%1 не подходит к остальным записям набора: %2. Резонатор определён по остальным.</translation>
    </message>
    <message>
        <source>The recordings do not fit one resonator, but they do without %1 (%2). Modes and resonator are refused: correct or leave out a recording.</source>
        <translation>Записи не подходят к одному резонатору, но подходят без %1 (%2). Моды и резонатор не приводятся: исправьте или исключите запись.</translation>
    </message>
    <message>
        <source>The recordings do not fit one resonator, and no single one of them makes the difference. Modes and resonator are refused: identify fewer recordings together.</source>
        <translation>Записи не подходят к одному резонатору, и исключение любой одной из них этого не меняет. Моды и резонатор не приводятся: определяйте резонатор по меньшему числу записей.</translation>
    </message>
    <message>
        <source>%1: the phasors of C turn at %2 from the reference, those of D at %3, as if Y of one had the other sign. Export both channels with one sign of Y, or exchange its sign in the file. The numbers hold only if the reference lies in the middle between two modes.</source>
        <translation>%1: комплексные амплитуды C вращаются относительно опорной частоты на %2, а D — на %3, как если бы Y одного из каналов имел другой знак. Запишите оба канала с одним знаком Y или смените его знак в файле. Числа верны, только если опорная частота лежит посередине между двумя модами.</translation>
    </message>
    <message>
        <source>%1: channel %2 beats in its amplitude and not in its phase, while the phase of channel %3 turns: the reference follows channel %2, as that of a phase-locked loop does, and has taken its frequency away. The numbers do not hold. {Give --phasors common with|Choose phasors of an oscillator that moves, with} a column of the reference&apos;s frequency (F) or phase (P), or log with a fixed reference.</source>
        <translation>%1: в канале %2 биения видны по амплитуде, но не по фазе, а фаза канала %3 поворачивается: опорный сигнал следует за каналом %2, как в петле ФАПЧ, и его частота потеряна. Числа неверны. Выберите комплексные амплитуды относительно перестраиваемого генератора и укажите столбец частоты (F) или фазы (P) опорного сигнала либо записывайте с неподвижной опорной частотой.</translation>
    </message>
    <message>
        <source>The strongest line stands at %1 Hz, beyond the reach of windows about the carrier given, %2 Hz{ (--f0)}: unless another line is meant, the numbers are those of no wave. Leave the carrier out so that it is looked for, or let a band-pass pass its line alone{ (--filter)}.</source>
        <translation>Самая сильная линия — на %1 Гц, вне досягаемости окон около заданной несущей %2 Гц{ (--f0)}: если не имелась в виду другая линия, числа не относятся ни к какой волне. Не задавайте несущую, чтобы программа нашла её сама, или выделите её линию полосовым фильтром{ (--filter)}.</translation>
    </message>
    <message>
        <source>%1: turned by the oscillator&apos;s phase the phasors wander, turned the other way they are %2 times as steady: the sign of Y is another one than told, or that of the phase. The numbers do not hold. {Give the other --y-sign|Choose the other sign of Y}, or change the sign of the phase in the file.</source>
        <translation>%1: при повороте на фазу генератора комплексные амплитуды блуждают, а при повороте в другую сторону они устойчивее (отношение %2): знак Y не тот, что указан, либо не тот знак фазы. Числа неверны. {Укажите другой --y-sign|Выберите другой знак Y} или смените знак фазы в файле.</translation>
    </message>
    <message>
        <source>%1: R^2 + S^2 + Q^2 differs from E^2 by %2 % about %3 s, by more than noise explains: a column has an offset, or a gain of its own, or the wave turns far within a row. The numbers may be off by more than their uncertainties. Calibrate the columns, or log faster.</source>
        <translation>%1: около %3 с сумма R² + S² + Q² отличается от E² на %2 %, больше, чем объясняет шум: в столбце есть сдвиг или своё усиление, либо за одну строку волна поворачивается далеко. Числа могут быть неверны больше, чем на свои неопределённости. Откалибруйте столбцы или записывайте журнал чаще.</translation>
    </message>
    <message>
        <source>The recordings differ by more than their noise: %1 (standard deviations). The combined uncertainties hold this spread.</source>
        <translation>Записи различаются больше, чем их шум: %1 (в СКО). Суммарные неопределённости включают этот разброс.</translation>
    </message>
    <message>
        <source>Two or three recordings do not show whether all are of one resonator. The combined uncertainties hold an assumed spread between them: of the decay rate by %1 %, of the split by %2 %, of the gain ratio by %3 %.</source>
        <translation>По двум или трём записям не видно, все ли они от одного резонатора. Суммарные неопределённости включают принятый разброс между ними: скорости затухания на %1 %, разночастотности на %2 %, отношения коэффициентов передачи на %3 %.</translation>
    </message>
    <message>
        <source>The frequencies of the recordings lie %1 ppm apart (%2: %3 Hz, %4: %5 Hz). A mean frequency and modes are refused.</source>
        <translation>Частоты записей отличаются на %1 млн⁻¹ (%2: %3 Гц, %4: %5 Гц). Средняя частота и моды не приводятся.</translation>
    </message>
    <message>
        <source>The residual is that of a damping by %1 (about %2 % of the damping at the largest amplitude), which the model does not hold: damping, its anisotropy, rotation and drifts may be off by more than their deviations. Fit parts of the recordings in which the amplitude changes less{ (--from, --to)}.</source>
        <translation>Невязка такая, как при затухании, которое создаёт %1 (около %2 % затухания при наибольшей амплитуде); в модели этого нет: затухание, разнодобротность, вращение и дрейф могут быть ошибочны больше своих СКО. Возьмите участки записей, где амплитуда меняется меньше.</translation>
    </message>
    <message>
        <source>Recording %1: this is no free decay: %2. Damping, Q and what rests on them may be off by more than their deviations.</source>
        <translation>Запись %1: это не свободный выбег: %2. Затухание, добротность и всё, что на них опирается, могут быть ошибочны больше своих СКО.</translation>
    </message>
    <message>
        <source>Recording %1: this is no free decay from start to end. From %2 s to %3 s it decays freely: {take this part (--from %2 --to %3)|set the range to this part}.</source>
        <translation>Запись %1: это не свободный выбег от начала до конца. От %2 с до %3 с выбег свободный: выберите этот участок диапазоном.</translation>
    </message>
    <message>
        <source>Recording %1: both channels show the same projection of the motion. The modes are seen, but no directions: axes and quadrature are refused. Place the pick-offs 45 degrees apart.</source>
        <translation>Запись %1: оба канала показывают одну и ту же проекцию движения. Видны моды, но не направления: оси и квадратура не определяются. Разнесите съёмы на 45 градусов.</translation>
    </message>
    <message>
        <source>The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): the motion is not that of a resonator in free decay, and modes and resonator are refused.</source>
        <translation>Мода %1 Гц росла бы со скоростью %2 1/с (СКО %3): это не движение резонатора в свободном выбеге, моды и резонатор не определяются.</translation>
    </message>
    <message>
        <source>%1: this %2 file is beyond a limit of this program: %3. %4.</source>
        <translation>%1: файл %2 превышает предел этой программы: %3. %4.</translation>
    </message>
    <message>
        <source>Columns that hold words are no channels and were passed over: %1.</source>
        <translation>Столбцы со словами — не каналы и пропущены: %1.</translation>
    </message>
    <message>
        <source>%1 is a pipe or a device, which cannot be read more than once. Save it to a file first, as in cat %1 &gt; FILE, and name that file.</source>
        <translation>%1 — канал или устройство, которые нельзя прочитать дважды. Сначала сохраните данные в файл, например cat %1 &gt; FILE, и укажите этот файл.</translation>
    </message>
    <message>
        <source>%1 states a sample rate of %2 Hz, and its times give %3 Hz. {Say which holds: --time-unit for the unit of the times, or --rate with one of both|Choose the unit of the times, or give the one that holds as the sample rate}.</source>
        <translation>%1: указана частота дискретизации %2 Гц, а по столбцу времени она равна %3 Гц. Выберите единицу времени или задайте верную из двух частот.</translation>
    </message>
    <message>
        <source>%1 holds no channel: it has no column or variable of several numbers that is no time. A recording holds the two pick-offs C and D.</source>
        <translation>%1: каналов нет: ни в одном столбце и ни в одной переменной, кроме времени, нет нескольких чисел. В записи два измерительных канала, C и D.</translation>
    </message>
    <message>
        <source>%1 has %2 channel(s), and %3 are needed: the two pick-offs C and D. Where D has a file of its own, {name it: --channel-d %4|drop both files into the window together, or choose %4 as D under Import}.</source>
        <translation>%1: каналов %2, а нужно %3: измерительные каналы C и D. Если канал D записан в отдельный файл, {укажите его: --channel-d %4|перетащите в окно оба файла вместе или выберите %4 каналом D в окне «Импорт»}.</translation>
    </message>
    <message>
        <source>%1 holds samples alone, and neither %2.anp nor %2.xml beside it tells their sample rate. Copy that file, too, or {give --raw f32 --raw-channels 1 --rate HZ|read it as raw samples under Import}.</source>
        <translation>%1: только отсчёты, а ни %2.anp, ни %2.xml рядом не сообщают частоту дискретизации. Скопируйте и этот файл или прочитайте как отсчёты без заголовка в окне «Импорт».</translation>
    </message>
    <message>
        <source>%1 and %2 are no parts of one recording: the %3 do not fit (%4 and %5). Choose files that were recorded together.</source>
        <translation>%1 и %2 не составляют одну запись: не согласуются %3 (%4 и %5). Выберите файлы, записанные вместе.</translation>
    </message>
    <message>
        <source>The times of channel D begin %1 s (%2 samples) after those of channel C; D was interpolated to C&apos;s times. What its times are wrong by is a phase between the channels ({--delay|delay of D}).</source>
        <translation>Отсчёты времени канала D начинаются на %1 с (%2 отсчёта) позже, чем у канала C; канал D интерполирован на моменты канала C. Погрешность этого сдвига — фаза между каналами (задержка D).</translation>
    </message>
    <message>
        <source>The %1 pieces do not tell when they begin: they are taken to follow each other without a gap.</source>
        <translation>Части записи (%1) не сообщают время начала: принято, что они следуют одна за другой без пропуска.</translation>
    </message>
    <message>
        <source>%1: there is no column &quot;%2&quot;; the file has %3. Name {the columns with --columns|others}.</source>
        <translation>%1: столбца «%2» нет; в файле есть %3. Назовите другие.</translation>
    </message>
    <message>
        <source>%1: column &quot;%2&quot; does not tell the unit of its angles. {Give it with --angle-unit: deg, rad or cyc|Choose degrees, radians or turns}.</source>
        <translation>%1: в столбце «%2» не указана единица углов. Выберите градусы, радианы или обороты.</translation>
    </message>
    <message>
        <source>%1: the wave turns by %2 degrees, too little to tell the second and the fourth harmonic of the drift from the turn itself. Let it turn by 180 degrees or more.</source>
        <translation>%1: волна поворачивается на %2 градусов: этого мало, чтобы отличить вторую и четвёртую гармоники дрейфа от самого поворота. Нужен поворот на 180 градусов или больше.</translation>
    </message>
    <message>
        <source>%1: R^2 + S^2 + Q^2 is %2 % of E^2, and has to be all of it. One of the columns is in another unit, or is something else: E is |c|^2 + |d|^2, R is |c|^2 - |d|^2, S and Q are twice the real and the imaginary part of c d*.</source>
        <translation>%1: сумма R² + S² + Q² составляет %2 % от E², а должна быть равна E². Один из столбцов записан в других единицах или содержит другую величину: E — это |c|² + |d|², R — |c|² − |d|², S и Q — удвоенные действительная и мнимая части c d*.</translation>
    </message>
    <message>
        <source>%1: each time the angle reaches an end, it comes back by %2 degrees. A wave&apos;s angle comes back by 90, 180 or 360 degrees, so its unit is another one. {Give it with --angle-unit: deg, rad or cyc|Choose degrees, radians or turns}.</source>
        <translation>%1: дойдя до края, угол каждый раз возвращается на %2 градуса. Угол волны возвращается на 90, 180 или 360 градусов, так что единица у него другая. Выберите градусы, радианы или обороты.</translation>
    </message>
    <message>
        <source>%1: the wave turns by 45 degrees or more from row to row, and its angle is wrapped: how far it turned is unknown. Log it faster, or write down the whole angle.</source>
        <translation>%1: от строки к строке волна поворачивается на 45 градусов или больше, а угол свёрнут: на сколько она повернулась, неизвестно. Записывайте журнал чаще или пишите непрерывный угол.</translation>
    </message>
    <message>
        <source>The logs differ in the harmonic %1 of the drift, by %2 deviations: %3. No common value is given.</source>
        <translation>Журналы расходятся в гармонике %1 дрейфа, на %2 СКО: %3. Общее значение не приводится.</translation>
    </message>
    <message>
        <source>%1 does not fit the other logs, in the harmonic %2 of the drift. The drift is that of the others.</source>
        <translation>%1 не согласуется с остальными журналами в гармонике %2 дрейфа. Дрейф определён по остальным.</translation>
    </message>
    <message>
        <source>Gain ratio and non-orthogonality of the channels within their tolerance give a wave that turns a fourth harmonic of %1, which u holds. A log of the opposite turn tells it from the drift{; a smaller tolerance (--tolerance kappa=...,skew=...) lowers u}.</source>
        <translation>Отношение коэффициентов передачи и неортогональность каналов в пределах допусков дают поворачивающейся волне четвёртую гармонику %1; она входит в u. От дрейфа её отличит журнал с обратным поворотом.</translation>
    </message>
    <message>
        <source>%1 wraps its angle at 90 degrees: the sign of the second harmonic is that of its first quarter of a turn.</source>
        <translation>%1: угол сворачивается через 90 градусов, поэтому знак второй гармоники — тот, что в первой четверти оборота.</translation>
    </message>
    <message>
        <source>%1 is a log, no recording: it holds %2. {Read it with %3, options of identify, compare, analyze and batch and columns of a measurement list|Open it with File, Open logs, or say in the measurement list what it is (%3)}; a set has logs or recordings, not both. If the columns are samples all the same, give them other names.</source>
        <translation>%1 — журнал, а не запись: в нём %2. Откройте его через «Файл», «Открыть журналы» или укажите в списке измерений, что это (%3); в наборе либо журналы, либо записи. Если в столбцах всё же отсчёты, назовите столбцы иначе.</translation>
    </message>
    <message>
        <source>%1 is a whole-angle log, no recording: it holds the angle of a standing wave over time. The {command drift reads|page Drift opens} it.</source>
        <translation>%1 — журнал интегрирующего режима, а не запись: в нём угол стоячей волны по времени. Его открывает страница «Дрейф».</translation>
    </message>
    <message>
        <source>%1 is no log: logs are tables as text, NPY, NPZ, MAT or HDF5. {analyze and identify read recordings|Recordings have a set of their own}, without logs beside them.</source>
        <translation>%1 — не журнал: журналы — таблицы в виде текста, NPY, NPZ, MAT или HDF5. {Записи читают команды analyze и identify|У записей отдельный набор}, без журналов.</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Tracks</source>
        <translation>Ряды</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Невязки</translation>
    </message>
    <message>
        <source>Resonator</source>
        <translation>Резонатор</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Окна</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Сигналы</translation>
    </message>
    <message>
        <source>History</source>
        <translation>История</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Дрейф</translation>
    </message>
</context>
<context>
    <name>PlotFocus</name>
    <message>
        <source>Plot of %1, %2</source>
        <translation>График %1, %2</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>not estimated by this algorithm</source>
        <translation>этим алгоритмом не оценивается</translation>
    </message>
    <message>
        <source>no window has a value</source>
        <translation>ни в одном окне нет значения</translation>
    </message>
</context>
<context>
    <name>PlotStack</name>
    <message>
        <source>and its trend</source>
        <translation>и его тренд</translation>
    </message>
    <message numerus="yes">
        <source>%n not drawn: other length or unit</source>
        <translation>
            <numerusform>%n не показан: другая длина или единица</numerusform>
            <numerusform>%n не показаны: другая длина или единица</numerusform>
            <numerusform>%n не показаны: другая длина или единица</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>The wave hardly moves, so that one direction of the resonator is seen and no other. Add a recording that starts at theta_A = %1 degrees and lasts %2 s or longer.</source>
        <translation>Волна почти неподвижна, поэтому видно одно направление резонатора и никакое другое. Добавьте запись, которая начинается при theta_A = %1° и длится не меньше %2 с.</translation>
    </message>
    <message>
        <source>At one angle a rotation and a damping anisotropy turn the wave alike. Add a recording that starts at theta_A = %1 degrees and lasts %2 s or longer.</source>
        <translation>При одном угле вращение и разнодобротность поворачивают волну одинаково. Добавьте запись, которая начинается при theta_A = %1° и длится не меньше %2 с.</translation>
    </message>
    <message>
        <source>The free model takes the channels as any two views of the modes: it has no angles.</source>
        <translation>Свободная модель считает каналы любыми двумя проекциями мод: углов в ней нет.</translation>
    </message>
    <message>
        <source>The two modes cannot be told apart.</source>
        <translation>Две моды не различить.</translation>
    </message>
    <message>
        <source>A circular wave has no angle.</source>
        <translation>У круговой волны нет угла.</translation>
    </message>
    <message>
        <source>The drift function needs starts at three angles, 22.5 degrees apart or more, or a wave that turns.</source>
        <translation>Для функции дрейфа нужны пуски не менее чем с трёх углов через 22,5 градуса или больше либо волна, которая поворачивается.</translation>
    </message>
    <message>
        <source>The fit stopped before it converged.</source>
        <translation>Подгонка остановилась, не сойдясь.</translation>
    </message>
    <message>
        <source>This recording has too few windows for it.</source>
        <translation>В этой записи для этого слишком мало окон.</translation>
    </message>
    <message>
        <source>The difference between the modes is within its noise: it is at most %1 %2, and has no axis.</source>
        <translation>Разность мод в пределах её шума: она не больше %1 %2 и оси не имеет.</translation>
    </message>
    <message>
        <source>The decay is within its noise: tau is at least %1 s. Record longer, and with the drive off, which holds the amplitude as well.</source>
        <translation>Затухание в пределах его шума: τ не меньше %1 с. Нужна более длинная запись, и с выключенным возбуждением: оно тоже поддерживает амплитуду.</translation>
    </message>
    <message>
        <source>In a turning wave a gain ratio of the channels and a damping anisotropy look the same. Calibrate the channels and state their tolerance, or add recordings that start at other angles.</source>
        <translation>У поворачивающейся волны отношение коэффициентов передачи каналов и разнодобротность неразличимы. Откалибруйте каналы и задайте их допуск или добавьте записи, начатые под другими углами.</translation>
    </message>
    <message>
        <source>The recordings hardly narrow its tolerance: the value is as given.</source>
        <translation>Записи почти не уточняют его в пределах допуска: остаётся заданное значение.</translation>
    </message>
    <message>
        <source>Taken as zero in the fit, because no tolerance is given for it; the sensitivities say what it would change.</source>
        <translation>При подгонке принято за нуль, так как допуск не задан; что изменилось бы, показывают чувствительности.</translation>
    </message>
    <message>
        <source>The recordings show no dependence on the amplitude: it is at most %1 Hz per squared recording unit.</source>
        <translation>Зависимость от амплитуды по записям не нужна: она не больше %1 Гц на квадрат единицы записи.</translation>
    </message>
    <message>
        <source>A drift of the frequency looks like the motion itself in this recording.</source>
        <translation>В этой записи уход частоты неотличим от самого движения.</translation>
    </message>
    <message>
        <source>The decay is hardly above its noise: tau lies between %1 s and %2 s.</source>
        <translation>Затухание едва выше его шума: τ лежит между %1 с и %2 с.</translation>
    </message>
    <message>
        <source>The wave grows, at a rate of %1 1/s (standard deviation %2).</source>
        <translation>Волна растёт со скоростью %1 1/с (СКО %2).</translation>
    </message>
    <message>
        <source>It depends on parameters of the resonator that these recordings do not show.</source>
        <translation>Зависит от параметров резонатора, которых эти записи не показывают.</translation>
    </message>
    <message>
        <source>The frequency changes while the amplitude falls: whether it follows the amplitude or settles in time, these recordings do not tell. Add one that starts at another amplitude.</source>
        <translation>Частота меняется, пока падает амплитуда: зависит она от амплитуды или устанавливается со временем, эти записи не показывают. Добавьте запись с другой начальной амплитудой.</translation>
    </message>
    <message>
        <source>It belongs to one direction, and no recording of the other side starts within 3 degrees of it.</source>
        <translation>Относится к одному направлению, а с другой стороны нет записи, начатой не дальше 3 градусов от него.</translation>
    </message>
    <message>
        <source>The modes of both sides are not named by the same: one by frequency, the other by decay.</source>
        <translation>Моды двух сторон названы по-разному: одни по частоте, другие по затуханию.</translation>
    </message>
    <message>
        <source>The recordings do not fit one resonator (see the warnings).</source>
        <translation>Записи не подходят к одному резонатору (см. предупреждения).</translation>
    </message>
    <message>
        <source>The recording does not fit the others and is left out of the set.</source>
        <translation>Запись не подходит к остальным и исключена из набора.</translation>
    </message>
    <message>
        <source>The frequencies of the recordings lie %1 ppm apart: each recording has its own.</source>
        <translation>Частоты записей отличаются на %1 млн⁻¹: у каждой записи своя.</translation>
    </message>
    <message>
        <source>The mode at %1 Hz would grow, at a rate of %2 1/s (standard deviation %3): the motion is not that of a resonator in free decay.</source>
        <translation>Мода %1 Гц росла бы со скоростью %2 1/с (СКО %3): это не движение резонатора в свободном выбеге.</translation>
    </message>
    <message>
        <source>Both channels show the same projection of the motion: the modes are seen, directions are not.</source>
        <translation>Оба канала показывают одну и ту же проекцию движения: видны моды, но не направления.</translation>
    </message>
    <message>
        <source>The logs differ in it, or in what it is found from.</source>
        <translation>Журналы расходятся в этом или в том, из чего это найдено.</translation>
    </message>
    <message>
        <source>No log holds the effort of the controller for it.</source>
        <translation>Ни в одном журнале нет нужного для этого управляющего воздействия.</translation>
    </message>
    <message>
        <source>The mean of the amplitude effort is below zero, as if it took energy from the wave. Write both efforts with the signs with which they raise a_A and a_B.</source>
        <translation>Среднее воздействие по амплитуде отрицательно, как если бы оно отнимало энергию у волны. Запишите оба воздействия с теми знаками, с которыми они увеличивают a_A и a_B.</translation>
    </message>
    <message>
        <source>The fourth harmonic of the effort, or of the drift, is within its noise. Record a longer log.</source>
        <translation>Четвёртая гармоника воздействия или дрейфа не превышает шума. Запишите журнал длиннее.</translation>
    </message>
    <message>
        <source>The axes of damping by the effort and by the drift lie %1 degrees apart: the fourth harmonic of the drift is not that of the damping alone.</source>
        <translation>Оси затухания по воздействию и по дрейфу расходятся на %1 градусов: четвёртая гармоника дрейфа вызвана не только затуханием.</translation>
    </message>
    <message>
        <source>The log keeps no phase of the oscillation, and with it no frequency.</source>
        <translation>Журнал не хранит фазу колебаний, а с нею и частоту.</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Of the resonator</source>
        <translation>О резонаторе</translation>
    </message>
    <message>
        <source>Of the analyses</source>
        <translation>О расчётах</translation>
    </message>
    <message>
        <source>Of the recordings in the fit</source>
        <translation>О записях в подгонке</translation>
    </message>
    <message>
        <source>Statistical</source>
        <translation>Статист.</translation>
    </message>
    <message>
        <source>Combined u</source>
        <translation>Суммарн. u</translation>
    </message>
    <message>
        <source>Expanded U = 2u</source>
        <translation>Расшир. U = 2u</translation>
    </message>
    <message>
        <source>All sets</source>
        <translation>Все наборы</translation>
    </message>
    <message>
        <source>not finished yet</source>
        <translation>ещё не закончена</translation>
    </message>
    <message>
        <source>no findings</source>
        <translation>замечаний нет</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Начало</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Частота дискретизации</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длина</translation>
    </message>
    <message>
        <source>not computed yet</source>
        <translation>ещё не вычислена</translation>
    </message>
    <message>
        <source>Check: %1</source>
        <translation>Проверка: %1</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Запись</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>Алгоритм</translation>
    </message>
    <message>
        <source>Window, step (samples)</source>
        <translation>Окно, шаг (отсчёты)</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Окна</translation>
    </message>
    <message>
        <source>Mean frequency</source>
        <translation>Средняя частота</translation>
    </message>
    <message>
        <source>Instant of the mean</source>
        <translation>Момент среднего</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>Шум σ</translation>
    </message>
    <message>
        <source>Analyses and their settings</source>
        <translation>Расчёты и их настройки</translation>
    </message>
    <message>
        <source>Slow variables: %1</source>
        <translation>Медленные переменные: %1</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>События</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Время, с</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Событие</translation>
    </message>
    <message>
        <source>Further events: %1</source>
        <translation>Ещё событий: %1</translation>
    </message>
    <message>
        <source>No axis crossings, no gaps.</source>
        <translation>Переходов через оси и пропусков нет.</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Предупреждения</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Нет.</translation>
    </message>
    <message>
        <source>Gyro, serial number</source>
        <translation>Гироскоп, заводской номер</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Оператор</translation>
    </message>
    <message>
        <source>Date of measurement</source>
        <translation>Дата измерения</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Примечание</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>Отчёт составлен</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Страница %1 из %2</translation>
    </message>
    <message>
        <source>Report of a free decay</source>
        <translation>Отчёт о выбеге</translation>
    </message>
    <message>
        <source>Set, gyro</source>
        <translation>Набор, гироскоп</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Стр.</translation>
    </message>
    <message>
        <source>Mean f</source>
        <translation>Средняя f</translation>
    </message>
    <message>
        <source>Split Δf</source>
        <translation>Разночастотность Δf</translation>
    </message>
    <message>
        <source>Axis θ_w</source>
        <translation>Ось θ_w</translation>
    </message>
    <message>
        <source>Quality factor Q</source>
        <translation>Добротность Q</translation>
    </message>
    <message>
        <source>Report of free decays</source>
        <translation>Отчёт о выбегах</translation>
    </message>
    <message>
        <source>Values with their combined standard uncertainties u. A dash: the recordings do not show it; the page of the set gives the reason.</source>
        <translation>Значения с суммарной стандартной неопределённостью u. Прочерк: записи не показывают этой величины; причина названа на странице набора.</translation>
    </message>
    <message>
        <source>Values with their combined standard uncertainties u, with assumed tolerances of the channels. A dash: the recordings do not show it; the page of the set gives the reason.</source>
        <translation>Значения с суммарными стандартными неопределённостями u, с принятыми допусками каналов. Прочерк: записи этого не показывают; причина — на странице набора.</translation>
    </message>
    <message>
        <source>After the GUM (JCGM 100:2008): standard uncertainties in the unit of each parameter; u² is the sum of the squares; U has the coverage factor 2.</source>
        <translation>По GUM (JCGM 100:2008, ГОСТ Р 54500.3): стандартные неопределённости в единицах параметра; u² — сумма квадратов; у U коэффициент охвата 2.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Uncertainty budget</source>
        <translation>Бюджет неопределённости</translation>
    </message>
    <message>
        <source>Rim and drift function</source>
        <translation>Кромка и функция дрейфа</translation>
    </message>
    <message>
        <source>Balance of the channels, condition (30)</source>
        <translation>Баланс каналов, условие (30)</translation>
    </message>
    <message>
        <source>It has not been identified.</source>
        <translation>Он не идентифицирован.</translation>
    </message>
    <message>
        <source>Resonator</source>
        <translation>Резонатор</translation>
    </message>
    <message>
        <source>Identified with other settings or recordings than the present ones.</source>
        <translation>Идентифицирован с другими настройками или записями, чем нынешние.</translation>
    </message>
    <message>
        <source>Parameters, ± standard deviation (u: with the tolerances)</source>
        <translation>Параметры, ± СКО (u: с допусками)</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Пределы</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Моды</translation>
    </message>
    <message>
        <source>Waves of the recordings, without a model</source>
        <translation>Волны записей, без модели</translation>
    </message>
    <message>
        <source>Recordings in the fit</source>
        <translation>Записи в подгонке</translation>
    </message>
    <message>
        <source>Conditions: %1</source>
        <translation>Условия: %1</translation>
    </message>
    <message>
        <source>Without these recordings of the list: %1.</source>
        <translation>Без этих записей списка: %1.</translation>
    </message>
    <message>
        <source>Settings of the identification</source>
        <translation>Настройки идентификации</translation>
    </message>
    <message>
        <source>Report number</source>
        <translation>Номер отчёта</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Аппаратура</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Value ± U (k = 2)</source>
        <translation>Значение ± U (k = 2)</translation>
    </message>
    <message>
        <source>Tolerances (standard deviations): %1. %2</source>
        <translation>Допуски (СКО): %1. %2</translation>
    </message>
    <message>
        <source>Not shown by the recordings: %1.</source>
        <translation>Записи не определяют: %1.</translation>
    </message>
    <message>
        <source>Recordings: %1.</source>
        <translation>Записи: %1.</translation>
    </message>
    <message>
        <source>Errors that no residual shows would add</source>
        <translation>Ошибки, не видимые в невязке, добавили бы</translation>
    </message>
    <message>
        <source>All limits are kept.</source>
        <translation>Все пределы соблюдены.</translation>
    </message>
    <message>
        <source>Limits are not kept: %1.</source>
        <translation>Пределы не соблюдены: %1.</translation>
    </message>
    <message>
        <source>No verdict: by the warnings, the numbers may be wrong.</source>
        <translation>Заключения нет: по предупреждениям, числа могут быть ошибочны.</translation>
    </message>
    <message>
        <source>No verdict; not shown to be kept: %1.</source>
        <translation>Заключения нет; соблюдение пределов не доказано: %1.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Подпись</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Измерил</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Проверил</translation>
    </message>
    <message>
        <source>Approved</source>
        <translation>Утвердил</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Подписи</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Whole-angle logs alone</source>
        <translation>Только журналы интегрирующего режима</translation>
    </message>
    <message>
        <source>Drift of the whole angle</source>
        <translation>Дрейф в интегрирующем режиме</translation>
    </message>
    <message>
        <source>Drift of the angle</source>
        <translation>Дрейф угла</translation>
    </message>
    <message>
        <source>Resonator, from drift and efforts</source>
        <translation>Резонатор по дрейфу и воздействиям</translation>
    </message>
    <message>
        <source>Of the drift of the whole angle</source>
        <translation>О дрейфе в интегрирующем режиме</translation>
    </message>
    <message>
        <source>Report of whole-angle logs</source>
        <translation>Отчёт о журналах интегрирующего режима</translation>
    </message>
    <message>
        <source>Not shown to be kept: %1.</source>
        <translation>Соблюдение не доказано: %1.</translation>
    </message>
</context>
<context>
    <name>Residuals</name>
    <message>
        <source>normal</source>
        <translation>нормальное</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Невязка</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>СКО</translation>
    </message>
    <message>
        <source>Probability density</source>
        <translation>Плотность вероятности</translation>
    </message>
    <message>
        <source>Amplitude density</source>
        <translation>Амплитудная плотность</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>Сдвиг</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>Autocorrelation</source>
        <translation>Автокорреляция</translation>
    </message>
    <message>
        <source>the wave itself</source>
        <translation>сама волна</translation>
    </message>
    <message>
        <source>the wave, at the rate of the windows</source>
        <translation>волна, с частотой следования окон</translation>
    </message>
    <message>
        <source>image of the line at %1 Hz by the windows</source>
        <translation>отражение линии %1 Гц окнами</translation>
    </message>
    <message>
        <source>Each window takes up a little of that line, which makes images beside the carrier. Without the line they are gone, too.</source>
        <translation>Каждое окно забирает немного той линии, отчего рядом с несущей появляются её отражения. Без линии исчезают и они.</translation>
    </message>
    <message>
        <source>supply of %1 Hz</source>
        <translation>сеть %1 Гц</translation>
    </message>
    <message>
        <source>supply of %1 Hz, harmonic %2</source>
        <translation>сеть %1 Гц, гармоника %2</translation>
    </message>
    <message>
        <source>carrier modulated at %1 Hz</source>
        <translation>несущая, модулированная частотой %1 Гц</translation>
    </message>
    <message>
        <source>harmonic %1 of the carrier</source>
        <translation>гармоника %1 несущей</translation>
    </message>
    <message>
        <source>harmonic %1 of the carrier, folded</source>
        <translation>гармоника %1 несущей, наложенная</translation>
    </message>
    <message>
        <source>another mode</source>
        <translation>другая мода</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>источник неизвестен</translation>
    </message>
    <message>
        <source>This is the wave itself: it changes inside the windows, or another mode lies beside it. Shorter windows follow a change.</source>
        <translation>Это сама волна: она меняется внутри окон, или рядом с ней лежит другая мода. Более короткие окна успевают за изменением.</translation>
    </message>
    <message>
        <source>The distance from the carrier is a multiple of the rate of the windows: the wave changes inside them. Shorter windows follow it.</source>
        <translation>Расстояние до несущей кратно частоте следования окон: волна меняется внутри них. Более короткие окна успевают за ней.</translation>
    </message>
    <message>
        <source>An electrical supply couples into the pick-offs.</source>
        <translation>Наводка электрической сети на датчики.</translation>
    </message>
    <message>
        <source>The distance from the carrier is that of the mains: they modulate the wave or its pick-off.</source>
        <translation>Расстояние до несущей кратно частоте сети: сеть модулирует волну или её съём.</translation>
    </message>
    <message>
        <source>A pick-off or the suspension is not linear, or samples are clipped.</source>
        <translation>Датчик или подвес нелинеен, или отсчёты ограничены.</translation>
    </message>
    <message>
        <source>It lies above half the sample rate and appears as an alias. A pick-off is not linear, or samples are clipped.</source>
        <translation>Она лежит выше половины частоты дискретизации и видна из-за наложения спектров. Датчик нелинеен, или отсчёты ограничены.</translation>
    </message>
    <message>
        <source>It decays in this range as a mode of the resonator does.</source>
        <translation>На этом участке она затухает, как мода резонатора.</translation>
    </message>
    <message>
        <source>It is no harmonic of the carrier or the mains, and no decay is seen in this range.</source>
        <translation>Это не гармоника несущей или сети, и затухания на этом участке не видно.</translation>
    </message>
    <message>
        <source>It is %1 times %2 Hz.</source>
        <translation>Это %1 × %2 Гц.</translation>
    </message>
    <message>
        <source>Samples per channel: %1.</source>
        <translation>Отсчётов на канал: %1.</translation>
    </message>
    <message>
        <source>The range has %1; blocks at even distances stand for all of them.</source>
        <translation>На участке их %1; все их представляют блоки на равных расстояниях.</translation>
    </message>
    <message>
        <source>Left out, because no wave was found there: %1.</source>
        <translation>Исключено, так как волны там нет: %1.</translation>
    </message>
    <message>
        <source>The windows take up %1 % of the noise, around the carrier.</source>
        <translation>На параметры окон уходит %1 % шума, вокруг несущей.</translation>
    </message>
    <message>
        <source>sd of the residual</source>
        <translation>СКО невязки</translation>
    </message>
    <message>
        <source>Standard deviation of the residual about its mean</source>
        <translation>Среднеквадратическое отклонение невязки от её среднего</translation>
    </message>
    <message>
        <source>Noise per sample</source>
        <translation>Шум на отсчёт</translation>
    </message>
    <message>
        <source>Standard deviation of white noise that leaves this residual: the parameters of a window take up a part of it. Unknown after a band-pass filter.</source>
        <translation>СКО белого шума, который даёт такую невязку: часть его уходит на параметры окна. После полосового фильтра неизвестен.</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Среднее</translation>
    </message>
    <message>
        <source>Mean of the residual. Beyond four standard deviations: an offset of the channel, or a slow disturbance.</source>
        <translation>Среднее невязки. Больше четырёх СКО — сдвиг канала или медленная помеха.</translation>
    </message>
    <message>
        <source>Skewness</source>
        <translation>Асимметрия</translation>
    </message>
    <message>
        <source>0 for normal noise, with the standard deviation of so many independent samples</source>
        <translation>Для нормального шума 0, с СКО для стольких независимых отсчётов</translation>
    </message>
    <message>
        <source>Excess kurtosis</source>
        <translation>Эксцесс</translation>
    </message>
    <message>
        <source>0 for normal noise; below it with a steady line, above it with outliers or a noise that changes</source>
        <translation>Для нормального шума 0; меньше при постоянной линии, больше при выбросах или меняющемся шуме</translation>
    </message>
    <message>
        <source>Largest deviation, in sd</source>
        <translation>Наибольшее отклонение, в СКО</translation>
    </message>
    <message>
        <source>The largest deviation from the mean in standard deviations, and how many samples of normal noise lie beyond it on average</source>
        <translation>Наибольшее отклонение от среднего в СКО и сколько отсчётов нормального шума в среднем отклоняются сильнее</translation>
    </message>
    <message>
        <source>%1 (expected beyond it: %2 samples)</source>
        <translation>%1 (за ним ожидается отсчётов: %2)</translation>
    </message>
    <message>
        <source>%1 Hz: %2</source>
        <translation>%1 Гц: %2</translation>
    </message>
    <message>
        <source>%1 … %2 Hz</source>
        <translation>%1 … %2 Гц</translation>
    </message>
    <message>
        <source>Amplitude: C %1, D %2.</source>
        <translation>Амплитуда: C %1, D %2.</translation>
    </message>
    <message>
        <source>A band-pass filter removes it.</source>
        <translation>Её убирает полосовой фильтр.</translation>
    </message>
</context>
<context>
    <name>Resonator</name>
    <message>
        <source>Mean frequency f</source>
        <translation>Средняя частота f</translation>
    </message>
    <message>
        <source>Of both modes, mean of the recordings</source>
        <translation>Двух мод, среднее по записям</translation>
    </message>
    <message>
        <source>Frequency split Δf</source>
        <translation>Разночастотность Δf</translation>
    </message>
    <message>
        <source>f_p − f_q of the two modes, never negative</source>
        <translation>f_p − f_q двух мод, неотрицательная</translation>
    </message>
    <message>
        <source>Stiffness axis θ_w</source>
        <translation>Ось жёсткости θ_w</translation>
    </message>
    <message>
        <source>Axis of the mode with the higher frequency</source>
        <translation>Ось моды с более высокой частотой</translation>
    </message>
    <message>
        <source>Decay time τ</source>
        <translation>Время затухания τ</translation>
    </message>
    <message>
        <source>In which the amplitude falls to 1/e</source>
        <translation>За которое амплитуда уменьшается в e раз</translation>
    </message>
    <message>
        <source>Quality factor Q</source>
        <translation>Добротность Q</translation>
    </message>
    <message>
        <source>Q = π f τ, from the coherent fit</source>
        <translation>Q = π f τ, по когерентной подгонке</translation>
    </message>
    <message>
        <source>Damping anisotropy g</source>
        <translation>Разнодобротность g</translation>
    </message>
    <message>
        <source>Difference of 1/τ of both axes of damping, never negative</source>
        <translation>Разность 1/τ двух осей затухания, неотрицательная</translation>
    </message>
    <message>
        <source>Damping axis θ_τ</source>
        <translation>Ось затухания θ_τ</translation>
    </message>
    <message>
        <source>Axis of larger damping</source>
        <translation>Ось большего затухания</translation>
    </message>
    <message>
        <source>Rotation −kΩ</source>
        <translation>Вращение −kΩ</translation>
    </message>
    <message>
        <source>Drift of θ_A that is the same at every angle</source>
        <translation>Дрейф θ_A, одинаковый при любом угле</translation>
    </message>
    <message>
        <source>Gain ratio κ</source>
        <translation>Отношение коэффициентов передачи κ</translation>
    </message>
    <message>
        <source>D = κ S_D</source>
        <translation>D = κ S_D</translation>
    </message>
    <message>
        <source>Change of f per squared unit of amplitude</source>
        <translation>Изменение f на единицу квадрата амплитуды</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/с</translation>
    </message>
    <message>
        <source>Hz per squared unit</source>
        <translation>Гц на кв. единицу</translation>
    </message>
    <message>
        <source>deg/h</source>
        <translation>град/ч</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>град</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>нс</translation>
    </message>
    <message>
        <source>Mode %1: %2</source>
        <translation>Мода %1: %2</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>не изменился</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>изменился</translation>
    </message>
    <message>
        <source>not comparable</source>
        <translation>несравним</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>рад</translation>
    </message>
    <message>
        <source>°/h</source>
        <translation>°/ч</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>рад/с</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Моды</translation>
    </message>
    <message>
        <source>rec. units</source>
        <translation>ед. записи</translation>
    </message>
    <message>
        <source>Frequency offset</source>
        <translation>Отклонение частоты</translation>
    </message>
    <message>
        <source>From the mean frequency of the recordings</source>
        <translation>От средней частоты записей</translation>
    </message>
    <message>
        <source>Start angle θ_A</source>
        <translation>Начальный угол θ_A</translation>
    </message>
    <message>
        <source>Angle of the working wave at the start</source>
        <translation>Угол рабочей волны в начале</translation>
    </message>
    <message>
        <source>Amplitude of the working wave at the start</source>
        <translation>Амплитуда рабочей волны в начале</translation>
    </message>
    <message>
        <source>Amplitude of the quadrature wave at the start</source>
        <translation>Амплитуда квадратурной волны в начале</translation>
    </message>
    <message>
        <source>What of the frequency split makes the quadrature of this recording grow</source>
        <translation>Та часть разночастотности, от которой растёт квадратура этой записи</translation>
    </message>
    <message>
        <source>Q of this wave</source>
        <translation>Q этой волны</translation>
    </message>
    <message>
        <source>Of its envelope alone: the power of this recording. Q of the resonator is the mean of all directions</source>
        <translation>Только по огибающей, то есть по мощности этой записи. Q резонатора — среднее по всем направлениям</translation>
    </message>
    <message>
        <source>Q coherent</source>
        <translation>Q когерентная</translation>
    </message>
    <message>
        <source>Quality factor from the coherent fit of all recordings</source>
        <translation>Добротность по когерентной подгонке всех записей</translation>
    </message>
    <message>
        <source>Frequency drift</source>
        <translation>Уход частоты</translation>
    </message>
    <message>
        <source>Of this recording, over time</source>
        <translation>В этой записи, со временем</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>Шум σ</translation>
    </message>
    <message>
        <source>Standard deviation per sample and channel</source>
        <translation>СКО на отсчёт и канал</translation>
    </message>
    <message>
        <source>Windows used</source>
        <translation>Взято окон</translation>
    </message>
    <message>
        <source>Without gaps and faults, of all; samples in each</source>
        <translation>Без пропусков и дефектов, из всех; отсчётов в окне</translation>
    </message>
    <message>
        <source>%1 of %2, n = %3</source>
        <translation>%1 из %2, n = %3</translation>
    </message>
    <message>
        <source>Mean drift</source>
        <translation>Средний дрейф</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Заключение</translation>
    </message>
    <message>
        <source>Passport</source>
        <translation>Паспорт</translation>
    </message>
    <message>
        <source>in the passport: %1</source>
        <translation>в паспорте: %1</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>подгонка</translation>
    </message>
    <message>
        <source>passport</source>
        <translation>паспорт</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Гармоники</translation>
    </message>
    <message>
        <source>resonator</source>
        <translation>резонатор</translation>
    </message>
    <message>
        <source>Non-orthogonality ε</source>
        <translation>Неортогональность ε</translation>
    </message>
    <message>
        <source>Angle between the pick-offs less 90 degrees</source>
        <translation>Угол между датчиками без 90 градусов</translation>
    </message>
    <message>
        <source>Delay δ</source>
        <translation>Задержка δ</translation>
    </message>
    <message>
        <source>By how much channel D comes late</source>
        <translation>На сколько запаздывает канал D</translation>
    </message>
    <message>
        <source>Amplitude dependence β</source>
        <translation>Зависимость от амплитуды β</translation>
    </message>
    <message>
        <source>Difference, u</source>
        <translation>Разность, u</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Разность</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Относительно</translation>
    </message>
    <message>
        <source>Recording %1: %2 of its direction</source>
        <translation>Запись %1: %2 её направления</translation>
    </message>
    <message>
        <source>Frequency of the wave</source>
        <translation>Частота волны</translation>
    </message>
    <message>
        <source>Mean rate of its phase, by power of both channels</source>
        <translation>Средняя скорость её фазы по мощности обоих каналов</translation>
    </message>
    <message>
        <source>Decay time of the wave</source>
        <translation>Время затухания волны</translation>
    </message>
    <message>
        <source>Of √(a_A² + a_B²)</source>
        <translation>По √(a_A² + a_B²)</translation>
    </message>
    <message>
        <source>Drift dθ_A/dt</source>
        <translation>Дрейф dθ_A/dt</translation>
    </message>
    <message>
        <source>Mean rate of the angle of the working wave</source>
        <translation>Средняя скорость угла рабочей волны</translation>
    </message>
    <message>
        <source>Quadrature growth d(a_B/a_A)/dt</source>
        <translation>Рост квадратуры d(a_B/a_A)/dt</translation>
    </message>
    <message>
        <source>Mean rate of the ratio of both waves</source>
        <translation>Средняя скорость отношения двух волн</translation>
    </message>
    <message>
        <source>0.1° of non-orthogonality</source>
        <translation>0,1° неортогон.</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>млн⁻¹</translation>
    </message>
    <message>
        <source>10⁻⁶ rad/s of the 8th harmonic of drift</source>
        <translation>10⁻⁶ рад/с 8-й гармоники дрейфа</translation>
    </message>
    <message>
        <source>10 µHz between the axes by amplitude</source>
        <translation>10 мкГц между осями от амплитуды</translation>
    </message>
    <message>
        <source>10⁻⁴ of crosstalk</source>
        <translation>10⁻⁴ проникания</translation>
    </message>
    <message>
        <source>Calibrate with δ = %1 µs</source>
        <translation>Калибровать с δ = %1 мкс</translation>
    </message>
    <message>
        <source>Remove the offsets of the channels</source>
        <translation>Убрать смещения каналов</translation>
    </message>
    <message>
        <source>Calibrate with κ = %1</source>
        <translation>Калибровать с κ = %1</translation>
    </message>
    <message>
        <source>Frequencies by the clock of the recorder.</source>
        <translation>Частоты — по часам регистратора.</translation>
    </message>
    <message>
        <source>u, where it differs, holds the tolerances (Calibration) too: %1.</source>
        <translation>u, если отличается, содержит и допуски (Калибровка): %1.</translation>
    </message>
    <message>
        <source>± is the statistical standard deviation.</source>
        <translation>± — статистическое СКО.</translation>
    </message>
    <message>
        <source>%1 (assumed)</source>
        <translation>%1 (принято)</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Частота дискретизации</translation>
    </message>
    <message>
        <source>Gain drift</source>
        <translation>Уход усиления</translation>
    </message>
    <message>
        <source>Phase drift</source>
        <translation>Уход фазы</translation>
    </message>
    <message>
        <source>Crosstalk</source>
        <translation>Проникание C в D</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Задержка</translation>
    </message>
    <message>
        <source>Non-orthogonality</source>
        <translation>Неортогональность</translation>
    </message>
    <message>
        <source>Gain ratio</source>
        <translation>Отношение коэффициентов передачи</translation>
    </message>
    <message>
        <source>10 ns of delay</source>
        <translation>10 нс задержки</translation>
    </message>
    <message>
        <source>10⁻⁴ rad of phase drift</source>
        <translation>10⁻⁴ рад ухода фазы</translation>
    </message>
    <message>
        <source>10⁻⁴ of gain drift</source>
        <translation>10⁻⁴ ухода усиления</translation>
    </message>
    <message>
        <source>0.001 of κ</source>
        <translation>0,001 κ</translation>
    </message>
    <message>
        <source>10 µHz by amplitude</source>
        <translation>10 мкГц от амплитуды</translation>
    </message>
    <message>
        <source>1 % of damping by amplitude</source>
        <translation>1 % затухания от амплитуды</translation>
    </message>
    <message>
        <source>0.1 % of gain by amplitude</source>
        <translation>0,1 % усиления от амплитуды</translation>
    </message>
    <message>
        <source>f of this direction</source>
        <translation>f этого направления</translation>
    </message>
    <message>
        <source>Of a wave that stays in the direction in which this one starts</source>
        <translation>Волны, которая остаётся в том направлении, в котором эта начинается</translation>
    </message>
    <message>
        <source>τ of this direction</source>
        <translation>τ этого направления</translation>
    </message>
    <message>
        <source>gyro</source>
        <translation>гироскоп</translation>
    </message>
    <message>
        <source>date</source>
        <translation>дата</translation>
    </message>
    <message>
        <source>bias voltage</source>
        <translation>напряжение смещения</translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation>%1 В</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>the amplifiers are exchanged</source>
        <translation>усилители переставлены</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>оператор</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>примечание</translation>
    </message>
    <message>
        <source>Q over the amplitude</source>
        <translation>Q по амплитуде</translation>
    </message>
    <message>
        <source>Amplitude at which Q of this wave holds; Q at the largest and at the smallest amplitude</source>
        <translation>Амплитуда, к которой относится Q этой волны; Q при наибольшей и при наименьшей амплитуде</translation>
    </message>
    <message>
        <source>at %1; %2 at %3, %4 at %5</source>
        <translation>при %1; %2 при %3, %4 при %5</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Разброс</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Пределы</translation>
    </message>
    <message>
        <source>Since the passport</source>
        <translation>Отличие от паспорта</translation>
    </message>
    <message>
        <source>taken as zero</source>
        <translation>принято за нуль</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>как задано</translation>
    </message>
    <message>
        <source>Structured model</source>
        <translation>Модель с калиброванными датчиками</translation>
    </message>
    <message>
        <source>Free model</source>
        <translation>Свободная модель</translation>
    </message>
    <message>
        <source>u: with the tolerances.</source>
        <translation>u — с учётом допусков.</translation>
    </message>
    <message>
        <source>Squared residuals of its windows in the fit of all, in units of their noise; about 1 where there is nothing but noise</source>
        <translation>Квадраты невязок её окон при общей подгонке, в единицах их шума; около 1, если есть только шум</translation>
    </message>
    <message>
        <source>u: with the tolerances, some assumed.</source>
        <translation>u — с учётом допусков, часть их принята.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>Samples in each window</source>
        <translation>Отсчётов в каждом окне</translation>
    </message>
    <message>
        <source>no axis</source>
        <translation>нет оси</translation>
    </message>
    <message>
        <source>within the limit</source>
        <translation>в пределах допуска</translation>
    </message>
    <message>
        <source>± and (): standard deviation.</source>
        <translation>± и () — СКО;</translation>
    </message>
</context>
<context>
    <name>SetPanel</name>
    <message>
        <source>Set %1</source>
        <translation>Набор %1</translation>
    </message>
    <message>
        <source>Logs %1</source>
        <translation>Журналы %1</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>algorithm</source>
        <translation>алгоритм</translation>
    </message>
    <message>
        <source>window</source>
        <translation>окно</translation>
    </message>
    <message>
        <source>range</source>
        <translation>участок</translation>
    </message>
    <message>
        <source>carrier</source>
        <translation>несущая</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>фильтр</translation>
    </message>
    <message>
        <source>start values</source>
        <translation>начальные значения</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>калибровка</translation>
    </message>
</context>
<context>
    <name>SiPrefix</name>
    <message>
        <source>f</source>
        <translation>ф</translation>
    </message>
    <message>
        <source>p</source>
        <translation>п</translation>
    </message>
    <message>
        <source>n</source>
        <translation>н</translation>
    </message>
    <message>
        <source>µ</source>
        <translation>мк</translation>
    </message>
    <message>
        <source>m</source>
        <translation>м</translation>
    </message>
    <message>
        <source>k</source>
        <translation>к</translation>
    </message>
    <message>
        <source>M</source>
        <translation>М</translation>
    </message>
    <message>
        <source>G</source>
        <translation>Г</translation>
    </message>
    <message>
        <source>T</source>
        <translation>Т</translation>
    </message>
</context>
<context>
    <name>SignalPanel</name>
    <message>
        <source>Residual</source>
        <translation>Невязка</translation>
    </message>
</context>
<context>
    <name>SignalStack</name>
    <message>
        <source>sample %1</source>
        <translation>отсчёт %1</translation>
    </message>
    <message>
        <source>wave %1</source>
        <translation>волна %1</translation>
    </message>
    <message>
        <source>fitted wave</source>
        <translation>модельная волна</translation>
    </message>
    <message>
        <source>amplitude of the wave</source>
        <translation>амплитуда волны</translation>
    </message>
    <message>
        <source>rms of the residual</source>
        <translation>СКЗ невязки</translation>
    </message>
</context>
<context>
    <name>SlowVariable</name>
    <message>
        <source>amplitude of the working wave</source>
        <translation>амплитуда рабочей стоячей волны</translation>
    </message>
    <message>
        <source>amplitude of the quadrature wave</source>
        <translation>амплитуда квадратурной стоячей волны</translation>
    </message>
    <message>
        <source>angle of the standing wave</source>
        <translation>угол стоячей волны</translation>
    </message>
    <message>
        <source>mean frequency</source>
        <translation>средняя частота</translation>
    </message>
    <message>
        <source>phase difference of the pick-off signals</source>
        <translation>разность фаз измерительных сигналов</translation>
    </message>
    <message>
        <source>phase of the standing waves</source>
        <translation>фаза стоячих волн</translation>
    </message>
    <message>
        <source>noise per sample and channel, of the residual</source>
        <translation>шум на отсчёт и канал, по невязке</translation>
    </message>
    <message>
        <source>root of the error functional F</source>
        <translation>корень из функционала ошибки F</translation>
    </message>
    <message>
        <source>orthogonality of the standing waves, relative</source>
        <translation>ортогональность стоячих волн, относительная</translation>
    </message>
</context>
<context>
    <name>Store</name>
    <message>
        <source>Add this result</source>
        <translation>Добавить результат</translation>
    </message>
    <message>
        <source>Gyro</source>
        <translation>Гироскоп</translation>
    </message>
    <message>
        <source>The name under which the history of this resonator is kept</source>
        <translation>Имя, под которым хранится история этого резонатора</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Добавить</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>A result without a gyro has no history: name one.</source>
        <translation>У результата без гироскопа нет истории: назовите его.</translation>
    </message>
    <message>
        <source>Without a date the result stands behind all others.</source>
        <translation>Без даты результат стоит после всех остальных.</translation>
    </message>
    <message>
        <source>The result of %1 replaces that of %3 (set %4) in %2: the same recordings and settings.</source>
        <translation>Результат %1 заменяет в %2 результат %3 (набор %4): те же записи и параметры.</translation>
    </message>
    <message>
        <source>The result of %1 is in %2.</source>
        <translation>Результат %1 записан в %2.</translation>
    </message>
    <message>
        <source>Of the recordings, as in 31.03.2026 or 2026-03-31, with or without a time as in 14:05</source>
        <translation>Дата записей, как 31.03.2026 или 2026-03-31, со временем, как 14:05, или без него</translation>
    </message>
    <message>
        <source>A date is written as in 31.03.2026 or 2026-03-31, with or without a time as in 14:05.</source>
        <translation>Дата пишется как 31.03.2026 или 2026-03-31, со временем, как 14:05, или без него.</translation>
    </message>
</context>
<context>
    <name>Sweep</name>
    <message>
        <source>recommended</source>
        <translation>рекомендуется</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>отсчётов</translation>
    </message>
    <message>
        <source>Standard deviation of %1</source>
        <translation>СКО %1</translation>
    </message>
    <message>
        <source>scatter</source>
        <translation>разброс</translation>
    </message>
    <message>
        <source>stated sd</source>
        <translation>расчётное СКО</translation>
    </message>
    <message>
        <source>bound</source>
        <translation>граница</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>движение</translation>
    </message>
    <message>
        <source>leakage %1</source>
        <translation>утечка %1</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Невязка</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>шум</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>white</source>
        <translation>белый</translation>
    </message>
    <message>
        <source>Longer windows blur %1: at n = %2 its bend inside the window shifts the mean by %3, with a scatter of %4.</source>
        <translation>Более длинные окна смазывают %1: при n = %2 изгиб внутри окна сдвигает среднее на %3 при разбросе %4.</translation>
    </message>
    <message>
        <source>Longer windows are not better: at n = %2 the expected error of %1 is %3, here %4.</source>
        <translation>Более длинные окна не лучше: при n = %2 ожидаемая ошибка %1 равна %3, здесь %4.</translation>
    </message>
    <message>
        <source>Longer windows of the list are better by less than a quarter.</source>
        <translation>Более длинные окна списка лучше меньше чем на четверть.</translation>
    </message>
    <message>
        <source>In the longer windows of the list some variables have no value.</source>
        <translation>В более длинных окнах списка некоторые переменные не имеют значения.</translation>
    </message>
    <message>
        <source>It is the longest tried.</source>
        <translation>Это самое длинное из испытанных.</translation>
    </message>
    <message>
        <source>It is the shortest of the list, and %1 moves even inside it by more than its scatter.</source>
        <translation>Это самое короткое окно списка, и %1 даже внутри него меняется сильнее разброса.</translation>
    </message>
    <message>
        <source>Neighbouring values of %1 scatter %2 times as much as the white noise explains.</source>
        <translation>Соседние значения %1 разбросаны в %2 раза сильнее, чем объясняет белый шум.</translation>
    </message>
    <message>
        <source>Cramér-Rao bound</source>
        <translation>граница Крамера — Рао</translation>
    </message>
    <message>
        <source>shift by motion</source>
        <translation>сдвиг от движения</translation>
    </message>
    <message>
        <source>own leakage</source>
        <translation>своя утечка</translation>
    </message>
    <message>
        <source>n = %1, %2 ms, %3 periods</source>
        <translation>n = %1, %2 мс, периодов: %3</translation>
    </message>
    <message>
        <source>No window is recommended: a comparison needs two lengths with 14 undisturbed windows or more, and white noise between the lines of the spectrum.</source>
        <translation>Окно не рекомендуется: для сравнения нужны две длины, при которых есть не меньше 14 неповреждённых окон, и белый шум между линиями спектра.</translation>
    </message>
    <message>
        <source>Recommended: %1</source>
        <translation>Рекомендуемое окно: %1</translation>
    </message>
    <message>
        <source>No window suits all variables: here the expected error of %1 is %2 times its least in the list.</source>
        <translation>Ни одно окно не подходит всем переменным: здесь ожидаемая ошибка %1 в %2 раза больше наименьшей в списке.</translation>
    </message>
    <message>
        <source>From n = %1 to %2 no expected error exceeds %3 times its least in the list.</source>
        <translation>От n = %1 до %2 ни одна ожидаемая ошибка не превышает наименьшую в списке больше чем в %3 раза.</translation>
    </message>
    <message>
        <source>%1: scatter of %2 %3 %4 (stated %5, bound %6, shift by motion %7); noise %8</source>
        <translation>%1: разброс %2 %3 %4 (расчётное СКО %5, граница %6, сдвиг от движения %7); шум %8</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>окон</translation>
    </message>
    <message>
        <source>sd of the scatter</source>
        <translation>СКО разброса</translation>
    </message>
    <message>
        <source>leakage, algorithm %1</source>
        <translation>утечка, алгоритм %1</translation>
    </message>
    <message>
        <source>The wave moves inside %1 of its %2 windows, of which an analysis warns; its errors are the least all the same.</source>
        <translation>Волна меняется внутри %1 из %2 таких окон, о чём предупредит расчёт; погрешности всё же наименьшие.</translation>
    </message>
    <message>
        <source>Without the warning n = %1 is the best, with an error %2 times as large.</source>
        <translation>Без предупреждения лучшее n = %1, его погрешность больше в %2 раза.</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>line %1 of the list, column &quot;%2&quot;</source>
        <translation>строка %1 списка, столбец «%2»</translation>
    </message>
    <message>
        <source>a file of the folder</source>
        <translation>файл папки</translation>
    </message>
    <message>
        <source>phasors of a phasemeter or a lock-in</source>
        <translation>комплексные амплитуды фазометра или синхронного детектора</translation>
    </message>
    <message>
        <source>the wave&apos;s a, b and theta</source>
        <translation>величины a, b и theta волны</translation>
    </message>
    <message>
        <source>%1 is named twice</source>
        <translation>%1 указано дважды</translation>
    </message>
    <message>
        <source>the powers E, R, S and Q</source>
        <translation>величины E, R, S и Q</translation>
    </message>
    <message>
        <source>a log without a phase has no frequency, and a delay is a phase at one: give the carrier f0, too</source>
        <translation>в журнале без фазы нет частоты, а задержка — это фаза на ней: задайте и несущую f0</translation>
    </message>
    <message>
        <source>%1 is smaller than %2 in %3 rows of %4, which it cannot be: the columns are exchanged or have unlike units</source>
        <translation>%1 меньше %2 в %3 строках из %4, чего быть не может: столбцы переставлены или в разных единицах</translation>
    </message>
    <message>
        <source>no wave stands out of the noise; choose the seconds of the decay, or other columns</source>
        <translation>волна не выделяется из шума; выберите время выбега или другие столбцы</translation>
    </message>
    <message>
        <source>no data show the sign of Y: give --y-sign + or -</source>
        <translation>знак Y по данным не виден: задайте --y-sign + или -</translation>
    </message>
    <message>
        <source>no data show whether amplitudes are peak values: give --amplitude peak or rms</source>
        <translation>по данным не видно, амплитудные ли это значения: задайте --amplitude peak или rms</translation>
    </message>
    <message>
        <source>the frequency of the oscillator is missing at %1, so that the phase is lost: cut there with --from or --to, or name a column P</source>
        <translation>частота генератора пропущена в %1, и фаза потеряна: отрежьте запись здесь через --from или --to или назовите столбец P</translation>
    </message>
    <message>
        <source>it needs the column of the oscillator&apos;s frequency or phase: name it F or P in --columns</source>
        <translation>нужен столбец частоты или фазы генератора: назовите его F или P в --columns</translation>
    </message>
    <message>
        <source>the oscillator&apos;s frequency moves from %1 to %2 (column %3), so that the reference is not fixed: choose --phasors common</source>
        <translation>частота генератора меняется от %1 до %2 (столбец %3), опорная частота не постоянна: выберите --phasors common</translation>
    </message>
    <message>
        <source>the clockbase in the header beside it makes %1 rows a second</source>
        <translation>clockbase в файле заголовка рядом даёт %1 строк в секунду</translation>
    </message>
    <message>
        <source>logs are not joined: put their rows into one file, or read each as a log of its own</source>
        <translation>журналы не соединяются: сложите их строки в один файл или читайте каждый как отдельный журнал</translation>
    </message>
    <message>
        <source>column %1 says that the reference is %2, and --f-ref that it is %3: leave --f-ref out, or correct it</source>
        <translation>в столбце %1 опорная частота %2, а --f-ref задаёт %3: уберите --f-ref или исправьте</translation>
    </message>
    <message>
        <source>the reference of channel D is %1, that of channel C %2: record both with one oscillator</source>
        <translation>опорная частота канала D %1, а канала C %2: запишите оба канала с одним генератором</translation>
    </message>
    <message>
        <source>FILE</source>
        <translation>ФАЙЛ</translation>
    </message>
    <message>
        <source>column %1 is the phase of X + iY itself: choose --phasors fixed</source>
        <translation>столбец %1 — это фаза самого X + iY: выберите --phasors fixed</translation>
    </message>
    <message>
        <source>the phase in column %1 moves, so that this is not the frame: choose --phasors %2</source>
        <translation>фаза в столбце %1 меняется, значит, система отсчёта не эта: задайте --phasors %2</translation>
    </message>
    <message>
        <source>the frequency of the reference is not in the file: give --f-ref</source>
        <translation>частоты опоры нет в файле: задайте --f-ref</translation>
    </message>
    <message>
        <source>it is a workbook; save the sheet as CSV</source>
        <translation>это книга таблиц; сохраните лист как CSV</translation>
    </message>
    <message>
        <source>the columns are parameter, least, greatest, gyro_type and comment</source>
        <translation>столбцы таблицы: parameter, least, greatest, gyro_type и comment</translation>
    </message>
    <message>
        <source>neither least nor greatest is there</source>
        <translation>нет ни least, ни greatest</translation>
    </message>
    <message>
        <source>%1 (gyro %2)</source>
        <translation>%1 (гироскоп %2)</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>превышена дисковая квота</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>слишком длинное имя файла</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>слишком большой файл</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>ошибка ввода-вывода</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>это каталог</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>на устройстве нет места</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>нет такого файла или каталога</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>это не каталог</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>действие не разрешено</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>нет прав доступа</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>файловая система только для чтения</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>открыто слишком много файлов</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>неизвестная ошибка</translation>
    </message>
    <message>
        <source>%1 (%2 was written)</source>
        <translation>%1 (записан %2)</translation>
    </message>
    <message>
        <source>it is a result of identify; --passport writes the passport</source>
        <translation>это результат команды identify; паспорт записывает --passport</translation>
    </message>
    <message>
        <source>its JSON is not a passport&apos;s</source>
        <translation>это JSON, но не паспорт</translation>
    </message>
    <message>
        <source>it is no JSON at byte %1</source>
        <translation>это не JSON, байт %1</translation>
    </message>
    <message>
        <source>it has more than %1 MiB</source>
        <translation>в нём больше %1 МиБ</translation>
    </message>
    <message>
        <source>its first bytes are not those of an array</source>
        <translation>первые байты — не заголовок массива</translation>
    </message>
    <message>
        <source>the format version %1</source>
        <translation>версию формата %1</translation>
    </message>
    <message>
        <source>its header is longer than it can be</source>
        <translation>заголовок длиннее возможного</translation>
    </message>
    <message>
        <source>its header cannot be understood</source>
        <translation>заголовок не разобрать</translation>
    </message>
    <message>
        <source>records of several fields</source>
        <translation>записи из нескольких полей</translation>
    </message>
    <message>
        <source>values of the type %1</source>
        <translation>значения типа %1</translation>
    </message>
    <message>
        <source>an array of %1 dimensions</source>
        <translation>массив размерности %1</translation>
    </message>
    <message>
        <source>its header promises more samples than any file can hold</source>
        <translation>по заголовку отсчётов больше, чем вместит любой файл</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>каналов: %1</translation>
    </message>
    <message>
        <source>it must lie between 2 and %1</source>
        <translation>допустимо от 2 до %1</translation>
    </message>
    <message>
        <source>it must be 0 to 1e15 bytes</source>
        <translation>допустимо от 0 до 1e15 байт</translation>
    </message>
    <message>
        <source>it must be a number other than 0</source>
        <translation>это должно быть число, не равное 0</translation>
    </message>
    <message>
        <source>the raw data of a channel cannot be as its index says</source>
        <translation>данные канала не могут быть такими, как сказано в его индексе</translation>
    </message>
    <message>
        <source>a channel whose type of number changes</source>
        <translation>канал, у которого меняется тип чисел</translation>
    </message>
    <message>
        <source>a scale that it does not describe (channel %1)</source>
        <translation>шкалу без описания (канал %1)</translation>
    </message>
    <message>
        <source>only the index of the .tdms file beside it</source>
        <translation>только индекс к файлу .tdms рядом</translation>
    </message>
    <message>
        <source>C and D at different sample rates</source>
        <translation>C и D с разными частотами дискретизации</translation>
    </message>
    <message>
        <source>channels of different lengths are interleaved</source>
        <translation>перемежаются каналы разной длины</translation>
    </message>
    <message>
        <source>its channels do not agree on the width of a row</source>
        <translation>каналы расходятся в ширине строки</translation>
    </message>
    <message>
        <source>a segment ends within a chunk of its raw data</source>
        <translation>сегмент обрывается внутри блока данных</translation>
    </message>
    <message>
        <source>it promises more samples than any file can hold</source>
        <translation>обещано больше отсчётов, чем вместит любой файл</translation>
    </message>
    <message>
        <source>the channel %1 has an impossible number of scales</source>
        <translation>у канала %1 невозможное число шкал</translation>
    </message>
    <message>
        <source>the channel %1 has scales that are each other&apos;s input</source>
        <translation>у канала %1 шкалы ссылаются друг на друга</translation>
    </message>
    <message>
        <source>the channel %1 has a scale whose input does not exist</source>
        <translation>у канала %1 шкала, вход которой не существует</translation>
    </message>
    <message>
        <source>the channel %1 has a linear scale without slope or intercept</source>
        <translation>у канала %1 линейная шкала без наклона или сдвига</translation>
    </message>
    <message>
        <source>the channel %1 has a polynomial scale without all of its coefficients</source>
        <translation>у канала %1 полиномиальная шкала без части коэффициентов</translation>
    </message>
    <message>
        <source>a scale of the kind &quot;%1&quot; (channel %2)</source>
        <translation>шкалу вида «%1» (канал %2)</translation>
    </message>
    <message>
        <source>there is no segment where one should begin</source>
        <translation>нет сегмента там, где он должен начинаться</translation>
    </message>
    <message>
        <source>a segment ends before its raw data</source>
        <translation>сегмент обрывается до своих данных</translation>
    </message>
    <message>
        <source>raw data of DAQmx that not all channels describe</source>
        <translation>данные DAQmx, описанные не для всех каналов</translation>
    </message>
    <message>
        <source>its metadata end too early</source>
        <translation>метаданные обрываются</translation>
    </message>
    <message>
        <source>the name of an object cannot be understood</source>
        <translation>имя объекта не разобрать</translation>
    </message>
    <message>
        <source>a channel&apos;s raw data are as before, and there are none before</source>
        <translation>данные канала «как прежде», но прежних нет</translation>
    </message>
    <message>
        <source>a property of the type %1</source>
        <translation>свойство типа %1</translation>
    </message>
    <message>
        <source>audio</source>
        <translation>звуковой</translation>
    </message>
    <message>
        <source>no sample can be reached at frame %1</source>
        <translation>к отсчёту %1 не перейти</translation>
    </message>
    <message>
        <source>the samples end at frame %1</source>
        <translation>отсчёты кончаются на %1-м</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>файл стал короче во время чтения</translation>
    </message>
    <message>
        <source>its packed data are wrong or end early</source>
        <translation>сжатые данные неверны или обрываются</translation>
    </message>
    <message>
        <source>its checksum is wrong</source>
        <translation>контрольная сумма неверна</translation>
    </message>
    <message>
        <source>SHA-256 is not available in OpenSSL</source>
        <translation>в OpenSSL нет SHA-256</translation>
    </message>
    <message>
        <source>its directory lies outside of it</source>
        <translation>оглавление лежит вне файла</translation>
    </message>
    <message>
        <source>its directory cannot be found</source>
        <translation>оглавление не найдено</translation>
    </message>
    <message>
        <source>the directory at its end is missing; the file was cut off</source>
        <translation>в конце нет оглавления; файл обрезан</translation>
    </message>
    <message>
        <source>its directory ends within an entry</source>
        <translation>оглавление обрывается внутри записи</translation>
    </message>
    <message>
        <source>an entry of its directory is incomplete</source>
        <translation>запись оглавления неполна</translation>
    </message>
    <message>
        <source>encrypted members</source>
        <translation>зашифрованные файлы</translation>
    </message>
    <message>
        <source>members packed by method %1</source>
        <translation>файлы, сжатые способом %1</translation>
    </message>
    <message>
        <source>%1 lies outside of it</source>
        <translation>%1 лежит вне файла</translation>
    </message>
    <message>
        <source>%1 is not where its directory says</source>
        <translation>%1 не там, где сказано в оглавлении</translation>
    </message>
    <message>
        <source>%1 cannot be as long as its directory says</source>
        <translation>%1 не может иметь длину, указанную в оглавлении</translation>
    </message>
    <message>
        <source>it must lie between 1e-6 and 1e12 Hz</source>
        <translation>допустимо от 10⁻⁶ до 10¹² Гц</translation>
    </message>
    <message>
        <source>C and D must be two channels</source>
        <translation>C и D должны быть разными каналами</translation>
    </message>
    <message>
        <source>a file is read as text or as raw</source>
        <translation>файл читается либо как текст, либо как двоичные отсчёты</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>there is no wave</source>
        <translation>волны нет</translation>
    </message>
    <message>
        <source>chi^2 + %1</source>
        <translation>хи² + %1</translation>
    </message>
    <message>
        <source>chi^2 of the free model - %1</source>
        <translation>хи² свободной модели − %1</translation>
    </message>
    <message>
        <source>rows of %1 numbers (a column is a channel, a row a time)</source>
        <translation>строки из %1 чисел (столбец — канал, строка — момент времени)</translation>
    </message>
    <message>
        <source>its root group cannot be read</source>
        <translation>корневая группа не читается</translation>
    </message>
    <message>
        <source>samples of %1 cannot be decoded</source>
        <translation>отсчёты %1 не декодируются</translation>
    </message>
    <message>
        <source>the samples of %1 cannot be found</source>
        <translation>отсчёты %1 не найдены</translation>
    </message>
    <message>
        <source>its groups lie more than %1 deep</source>
        <translation>вложенность групп больше %1</translation>
    </message>
    <message>
        <source>the group %1 cannot be read</source>
        <translation>группа %1 не читается</translation>
    </message>
    <message>
        <source>it has more than %1 objects</source>
        <translation>в нём больше %1 объектов</translation>
    </message>
    <message>
        <source>%1 cannot be read</source>
        <translation>%1 не читается</translation>
    </message>
    <message>
        <source>values for scale_factor and add_offset</source>
        <translation>значения с scale_factor и add_offset</translation>
    </message>
    <message>
        <source>%1 promises more samples than the file can hold</source>
        <translation>в %1 обещано больше отсчётов, чем вместит файл</translation>
    </message>
    <message>
        <source>complex numbers</source>
        <translation>комплексные числа</translation>
    </message>
    <message>
        <source>it is shorter than its header says: cut off, or never closed</source>
        <translation>он короче, чем сказано в заголовке: обрезан или не был закрыт</translation>
    </message>
    <message>
        <source>its header does not fit the file</source>
        <translation>заголовок не соответствует файлу</translation>
    </message>
    <message>
        <source>samples in other files</source>
        <translation>отсчёты в других файлах</translation>
    </message>
    <message>
        <source>samples packed by the filter number %1</source>
        <translation>отсчёты, сжатые фильтром номер %1</translation>
    </message>
    <message>
        <source>samples packed by the filter %1, number %2</source>
        <translation>отсчёты, сжатые фильтром %1, номер %2</translation>
    </message>
    <message>
        <source>line %1 is longer than 1 MiB</source>
        <translation>строка %1 длиннее 1 МиБ</translation>
    </message>
    <message>
        <source>no time response (dataset 58)</source>
        <translation>что угодно, кроме временных реализаций (набор 58)</translation>
    </message>
    <message>
        <source>a dataset 58 ends within its header</source>
        <translation>набор 58 обрывается в заголовке</translation>
    </message>
    <message>
        <source>a dataset 58 has %1 values, and its header says %2</source>
        <translation>в наборе 58 значений %1, а по заголовку %2</translation>
    </message>
    <message>
        <source>binary data of another dataset than 58 (%1)</source>
        <translation>двоичные данные другого набора, не 58 (%1)</translation>
    </message>
    <message>
        <source>the first line of a dataset 58b cannot be understood</source>
        <translation>первую строку набора 58b не разобрать</translation>
    </message>
    <message>
        <source>the header of a dataset 58 cannot be understood</source>
        <translation>заголовок набора 58 не разобрать</translation>
    </message>
    <message>
        <source>complex values</source>
        <translation>комплексные значения</translation>
    </message>
    <message>
        <source>unevenly spaced values</source>
        <translation>неравномерные значения</translation>
    </message>
    <message>
        <source>more than %1 channels</source>
        <translation>больше %1 каналов</translation>
    </message>
    <message>
        <source>floats of DEC VMS</source>
        <translation>числа с плавающей точкой DEC VMS</translation>
    </message>
    <message>
        <source>floats of IBM 5/370</source>
        <translation>числа с плавающей точкой IBM 5/370</translation>
    </message>
    <message>
        <source>binary numbers of an unknown format</source>
        <translation>двоичные числа неизвестного формата</translation>
    </message>
    <message>
        <source>binary values of the type %1</source>
        <translation>двоичные значения типа %1</translation>
    </message>
    <message>
        <source>the byte order of a dataset 58b is neither 1 nor 2</source>
        <translation>порядок байтов набора 58b не 1 и не 2</translation>
    </message>
    <message>
        <source>a dataset 58b has %1 bytes, and its header says %2 values of %3</source>
        <translation>в наборе 58b байтов %1, а по заголовку %2 значений по %3</translation>
    </message>
    <message>
        <source>line %1 is not a row of numbers</source>
        <translation>строка %1 — не строка чисел</translation>
    </message>
    <message>
        <source>line %1 has more values than the header says</source>
        <translation>в строке %1 значений больше, чем сказано в заголовке</translation>
    </message>
    <message>
        <source>its %1 times reach over %2 sample periods</source>
        <translation>%1 моментов времени занимают %2 периодов дискретизации</translation>
    </message>
    <message>
        <source>it ends at byte %1, inside of a variable</source>
        <translation>он кончается на байте %1, внутри переменной</translation>
    </message>
    <message>
        <source>there is no variable at byte %1</source>
        <translation>на байте %1 нет переменной</translation>
    </message>
    <message>
        <source>the size of the variable at byte %1 does not fit its numbers</source>
        <translation>размер переменной на байте %1 не соответствует её числам</translation>
    </message>
    <message>
        <source>it has more than %1 variables</source>
        <translation>в нём больше %1 переменных</translation>
    </message>
    <message>
        <source>it ends in its header</source>
        <translation>он кончается в заголовке</translation>
    </message>
    <message>
        <source>%1 is shorter than its header says</source>
        <translation>%1 короче, чем сказано в заголовке</translation>
    </message>
    <message>
        <source>the sheets of a workbook</source>
        <translation>листы книги электронных таблиц</translation>
    </message>
    <message>
        <source>members other than NumPy arrays (.npy)</source>
        <translation>файлы, которые не массивы NumPy (.npy)</translation>
    </message>
    <message>
        <source>the file was changed while it was read</source>
        <translation>файл изменился, пока его читали</translation>
    </message>
    <message>
        <source>the limit of the stack (ulimit -s)</source>
        <translation>предел стека (ulimit -s)</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 КБ</translation>
    </message>
    <message>
        <source>the program needs %1 kB or more</source>
        <translation>программе нужно не меньше %1 КБ</translation>
    </message>
    <message>
        <source>this system cannot confine the helper program that reads this format: it has no list of allowed system calls (seccomp)</source>
        <translation>эта система не может ограничить вспомогательную программу, которая читает этот формат: в ней нет списка разрешённых системных вызовов (seccomp)</translation>
    </message>
    <message>
        <source>its library returned no sensible list of variables</source>
        <translation>библиотека не вернула разумного списка переменных</translation>
    </message>
    <message>
        <source>its library returned nonsense</source>
        <translation>библиотека вернула бессмыслицу</translation>
    </message>
    <message>
        <source>its library did not come to an end within %1 s of processor time</source>
        <translation>библиотека не закончила за %1 с процессорного времени</translation>
    </message>
    <message>
        <source>its library stopped working on it for %1 s</source>
        <translation>библиотека не отвечала %1 с</translation>
    </message>
    <message>
        <source>its library did not come to an end</source>
        <translation>библиотека не закончила работу</translation>
    </message>
    <message>
        <source>its library was stopped when it tried to do more than read</source>
        <translation>библиотека остановлена при попытке не только читать</translation>
    </message>
    <message>
        <source>its library failed on it</source>
        <translation>библиотека завершилась на нём аварийно</translation>
    </message>
    <message>
        <source>%1 has %2 channels and stands alone</source>
        <translation>в %1 каналов %2, она указывается одна</translation>
    </message>
    <message>
        <source>they have %1 and %2 samples</source>
        <translation>в них %1 и %2 отсчётов</translation>
    </message>
    <message>
        <source>two sample rates, %1 and %2 Hz (--variables C,D,RATE tells which holds)</source>
        <translation>две частоты дискретизации, %1 и %2 Гц (какая верна, скажет --variables C,D,RATE)</translation>
    </message>
    <message>
        <source>columns %1 and %2 of different sample rates</source>
        <translation>столбцы %1 и %2 с разными частотами дискретизации</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not possible: %2</source>
        <translation>значение «%1» недопустимо: %2</translation>
    </message>
    <message>
        <source>an option has no dashes here</source>
        <translation>здесь параметр пишется без дефисов в начале</translation>
    </message>
    <message>
        <source>no row names a recording below it</source>
        <translation>ниже нет ни одной строки с записью</translation>
    </message>
    <message>
        <source>no file is named</source>
        <translation>файл не указан</translation>
    </message>
    <message>
        <source>the window is given in samples, too</source>
        <translation>окно задано и в отсчётах</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no date as in 2026-03-31 or 31.03.2026, with or without a time as in T14:05</source>
        <translation>«%1» не дата вида 2026-03-31 или 31.03.2026 (за ней может стоять время вида T14:05)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«%1» не число</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither yes nor no</source>
        <translation>«%1» — ни yes, ни no</translation>
    </message>
    <message>
        <source>the gyro</source>
        <translation>гироскоп</translation>
    </message>
    <message>
        <source>the type of the gyro</source>
        <translation>тип гироскопа</translation>
    </message>
    <message>
        <source>the bias voltage</source>
        <translation>напряжение смещения</translation>
    </message>
    <message>
        <source>the exchange of the amplifiers</source>
        <translation>перестановка усилителей</translation>
    </message>
    <message>
        <source>another program is writing it</source>
        <translation>его записывает другая программа</translation>
    </message>
    <message>
        <source>it is another kind of file</source>
        <translation>это файл другого вида</translation>
    </message>
    <message>
        <source>the list needs this column; its columns are %1</source>
        <translation>в списке должен быть этот столбец; его столбцы: %1</translation>
    </message>
    <message>
        <source>the folder has another list, %1</source>
        <translation>в папке есть другой список, %1</translation>
    </message>
    <message>
        <source>least and greatest are both empty</source>
        <translation>и least, и greatest пусты</translation>
    </message>
    <message>
        <source>it is above the greatest value</source>
        <translation>он больше наибольшего значения</translation>
    </message>
    <message>
        <source>%1 has a limit above already</source>
        <translation>у %1 выше уже есть предел</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2</source>
        <translation>«%1» нет среди %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is none of %2 (did you mean %3?)</source>
        <translation>«%1» нет среди %2 (имеется в виду %3?)</translation>
    </message>
    <message>
        <source>another result of this batch goes there</source>
        <translation>туда уже идёт другой результат этой обработки</translation>
    </message>
    <message>
        <source>it is the table of limits</source>
        <translation>это таблица допусков</translation>
    </message>
    <message>
        <source>the session has no recording of this number</source>
        <translation>в сеансе нет записи с таким номером</translation>
    </message>
    <message>
        <source>it must be a folder</source>
        <translation>это должна быть папка</translation>
    </message>
    <message>
        <source>samples in the encoding %1</source>
        <translation>отсчёты в кодировании %1</translation>
    </message>
    <message>
        <source>the phase in column %1 goes on by the whole carrier, %2: it is relative to no reference; leave --f-ref out</source>
        <translation>фаза в столбце %1 идёт со всей несущей, %2: она не относительно опоры; не задавайте --f-ref</translation>
    </message>
    <message>
        <source>column %1 holds deviations of a frequency: give the frequency by --f-ref</source>
        <translation>в столбце %1 отклонения частоты: задайте частоту параметром --f-ref</translation>
    </message>
    <message>
        <source>the line is longer than 1 MiB</source>
        <translation>строка длиннее 1 МиБ</translation>
    </message>
    <message>
        <source>it holds a zero byte</source>
        <translation>в нём нулевой байт</translation>
    </message>
    <message>
        <source>the name of a column</source>
        <translation>имя столбца</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lies below absolute zero, -273.15 C</source>
        <translation>«%1» ниже абсолютного нуля, −273,15 °C</translation>
    </message>
    <message>
        <source>the file holds no text</source>
        <translation>в файле не текст</translation>
    </message>
    <message>
        <source>the list needs this column</source>
        <translation>в списке нужен такой столбец</translation>
    </message>
    <message>
        <source>two columns have this name</source>
        <translation>такое имя у двух столбцов</translation>
    </message>
    <message>
        <source>&quot;%1&quot; stands below no name</source>
        <translation>над «%1» нет имени столбца</translation>
    </message>
    <message>
        <source>its quotation mark does not close</source>
        <translation>кавычка не закрыта</translation>
    </message>
    <message>
        <source>text follows its closing quotation mark</source>
        <translation>после закрывающей кавычки идёт текст</translation>
    </message>
    <message>
        <source>a NumPy file has room for one array only; let its name end in .npz</source>
        <translation>в файле NumPy есть место только для одного массива; дайте имени окончание .npz</translation>
    </message>
    <message>
        <source>libhdf5 cannot be loaded (%1)</source>
        <translation>не удалось загрузить libhdf5 (%1)</translation>
    </message>
    <message>
        <source>libhdf5 reports an error</source>
        <translation>libhdf5 сообщает об ошибке</translation>
    </message>
    <message>
        <source>a MAT file has room for 4 GiB in each variable, which %1 windows exceed; HDF5, NPZ and CSV have room for any number</source>
        <translation>в файле MAT на переменную отводится не больше 4 ГиБ, чего для %1 окон мало; в HDF5, NPZ и CSV их число не ограничено</translation>
    </message>
    <message>
        <source>the database is damaged (%1); take an earlier copy, or save what &quot;sqlite3 FILE .recover&quot; finds</source>
        <translation>база данных повреждена (%1); возьмите прежнюю копию или сохраните то, что найдёт «sqlite3 FILE .recover»</translation>
    </message>
    <message>
        <source>it is a database of another program</source>
        <translation>это база данных другой программы</translation>
    </message>
    <message>
        <source>a later version of Vybeg has made it (schema %1; this one knows %2)</source>
        <translation>файл создан более новой версией Vybeg (схема %1; этой версии известна схема %2)</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>это папка</translation>
    </message>
    <message>
        <source>it is no regular file</source>
        <translation>это не обычный файл</translation>
    </message>
    <message>
        <source>it holds no results</source>
        <translation>в нём нет результатов</translation>
    </message>
    <message>
        <source>another program has kept it locked for %1 s</source>
        <translation>другая программа не освобождает файл уже %1 с</translation>
    </message>
    <message>
        <source>the result is not there any more</source>
        <translation>этого результата больше нет</translation>
    </message>
    <message>
        <source>this name is too long for a file</source>
        <translation>это имя слишком длинно для файла</translation>
    </message>
    <message>
        <source>it is the list of the recordings</source>
        <translation>это список записей</translation>
    </message>
    <message>
        <source>it is one of the passports</source>
        <translation>это один из паспортов</translation>
    </message>
    <message>
        <source>it is one of the recordings</source>
        <translation>это одна из записей</translation>
    </message>
    <message>
        <source>it must be a file</source>
        <translation>это должен быть файл</translation>
    </message>
    <message>
        <source>the table goes there already</source>
        <translation>туда уже пишется таблица</translation>
    </message>
    <message>
        <source>it is an input, the table or the database</source>
        <translation>это исходный файл, таблица или база данных</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 или %2</translation>
    </message>
    <message>
        <source>the channels C and D of %1 are exchanged</source>
        <translation>каналы C и D записи %1 переставлены</translation>
    </message>
    <message>
        <source>the sign of channel D of %1 is reversed</source>
        <translation>знак канала D записи %1 обратный</translation>
    </message>
    <message>
        <source>the gain ratio of %1 is %2 times that of the others</source>
        <translation>отношение коэффициентов передачи записи %1 в %2 раза отличается от остальных</translation>
    </message>
    <message>
        <source>%1 hardly decays, the decay time of the others is %2 s</source>
        <translation>%1 почти не затухает, время затухания остальных %2 с</translation>
    </message>
    <message>
        <source>the decay time of %1 is %2 s, that of the others %3 s</source>
        <translation>время затухания записи %1 равно %2 с, остальных %3 с</translation>
    </message>
    <message>
        <source>the split or the stiffness axis of %1 is another</source>
        <translation>разночастотность или ось жёсткости записи %1 другие</translation>
    </message>
    <message>
        <source>the wave of %1 turns at another rate</source>
        <translation>волна записи %1 поворачивается с другой скоростью</translation>
    </message>
    <message>
        <source>more than one number of %1 differs</source>
        <translation>у записи %1 отличается не одно число</translation>
    </message>
    <message>
        <source>it is no free decay</source>
        <translation>это не свободный выбег</translation>
    </message>
    <message>
        <source>a drive ends or an amplifier changes its range</source>
        <translation>при отключении возбуждения или переключении диапазона усилителя</translation>
    </message>
    <message>
        <source>an amplifier changes its range</source>
        <translation>при переключении диапазона усилителя</translation>
    </message>
    <message>
        <source>so close to the carrier the gain or the phase of a channel that settles or follows the amplitude, or another mode</source>
        <translation>так близко к несущей это усиление или фаза канала, которые устанавливаются или следуют за амплитудой, либо ещё одна мода</translation>
    </message>
    <message>
        <source>another mode, or a disturbance that folds there</source>
        <translation>ещё одна мода или наложившаяся там помеха</translation>
    </message>
    <message>
        <source>does not remove it: record after the channels have settled, or with a smaller amplitude</source>
        <translation>её не уберёт: записывайте после установления каналов или с меньшей амплитудой</translation>
    </message>
    <message>
        <source>removes it</source>
        <translation>её уберёт</translation>
    </message>
    <message>
        <source>the decay rate by %1 %</source>
        <translation>скорость затухания на %1 %</translation>
    </message>
    <message>
        <source>the split by %1 %</source>
        <translation>разночастотность на %1 %</translation>
    </message>
    <message>
        <source>the gain ratio by %1 %</source>
        <translation>отношение коэффициентов передачи на %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>dry friction</source>
        <translation>сухое трение</translation>
    </message>
    <message>
        <source>the friction of air</source>
        <translation>трение о воздух</translation>
    </message>
    <message>
        <source>the squared amplitude</source>
        <translation>зависимость от квадрата амплитуды</translation>
    </message>
    <message>
        <source>its amplitude grows, by %1 1/s (standard deviation %2)</source>
        <translation>амплитуда растёт со скоростью %1 1/с (СКО %2)</translation>
    </message>
    <message>
        <source>its amplitude is held (decay rate %1 1/s), while that of the other recordings decays (%2 1/s)</source>
        <translation>амплитуда поддерживается (скорость затухания %1 1/с), а в остальных записях затухает (%2 1/с)</translation>
    </message>
    <message>
        <source>one of its two motions is held, as by a drive (decay rate %1 1/s), while the other decays (%2 1/s)</source>
        <translation>одно из двух её движений поддерживается, как возбуждением (скорость затухания %1 1/с), а другое затухает (%2 1/с)</translation>
    </message>
    <message>
        <source>its damping is by %1, the decay rate goes with the amplitude to the power %2 (standard deviation %3)</source>
        <translation>затухание создаёт %1, скорость затухания пропорциональна амплитуде в степени %2 (СКО %3)</translation>
    </message>
    <message>
        <source>samples packed in pieces of %1 MiB (a limit of this program is %2 MiB)</source>
        <translation>отсчёты, сжатые частями по %1 МиБ (предел этой программы — %2 МиБ)</translation>
    </message>
    <message>
        <source>Write a line for each time, with one number for each channel</source>
        <translation>Пишите строку на каждый момент времени, по числу на канал</translation>
    </message>
    <message>
        <source>it has more than %1 properties of scales</source>
        <translation>в нём больше %1 свойств шкал</translation>
    </message>
    <message>
        <source>its samples lie in more than %1 separate pieces</source>
        <translation>его отсчёты лежат более чем в %1 отдельных частях</translation>
    </message>
    <message>
        <source>it has more than %1 members</source>
        <translation>в нём больше %1 файлов</translation>
    </message>
    <message>
        <source>Save the recording in a file of its own</source>
        <translation>Сохраните запись в отдельном файле</translation>
    </message>
    <message>
        <source>Choose a smaller file</source>
        <translation>Выберите файл меньшего размера</translation>
    </message>
    <message>
        <source>Cut the recording where its clock jumps</source>
        <translation>Разрежьте запись там, где скачут её часы</translation>
    </message>
    <message>
        <source>integers of %1 bits; up to %2, and 64 in WAV, are read</source>
        <translation>целые числа по %1 бит; читаются до %2 и, в WAV, 64</translation>
    </message>
    <message>
        <source>Save the recording with 32 bits or as floats</source>
        <translation>Сохраните запись с 32 битами или в числах с плавающей точкой</translation>
    </message>
    <message>
        <source>samples from frame %1 on cannot be decoded</source>
        <translation>отсчёты с кадра %1 не декодируются</translation>
    </message>
    <message>
        <source>several chunks without a field timestamp</source>
        <translation>несколько частей (chunk) без поля timestamp</translation>
    </message>
    <message>
        <source>times that do not rise: name their column as t in --columns</source>
        <translation>времена, которые не возрастают: назовите их столбец t в --columns</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>нет %1</translation>
    </message>
    <message>
        <source>%1: %2 is expected, and %3 is there</source>
        <translation>%1: ожидается %2, а там %3</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>объект</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>список</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>текст</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>число</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>целое число</translation>
    </message>
    <message>
        <source>a number that is not negative</source>
        <translation>неотрицательное число</translation>
    </message>
    <message>
        <source>a positive number</source>
        <translation>положительное число</translation>
    </message>
    <message>
        <source>its schema %1 is that of an early version, which is read no longer: identify its recordings again</source>
        <translation>его схема %1 — схема ранней версии, которая больше не читается: идентифицируйте его записи заново</translation>
    </message>
    <message>
        <source>a reason known here</source>
        <translation>известная здесь причина</translation>
    </message>
    <message>
        <source>structured or free</source>
        <translation>structured или free</translation>
    </message>
    <message>
        <source>an order of the modes</source>
        <translation>порядок мод</translation>
    </message>
    <message>
        <source>a list as long as that of the times</source>
        <translation>список той же длины, что и времена</translation>
    </message>
    <message>
        <source>a list as long as that of the names</source>
        <translation>список той же длины, что и имена</translation>
    </message>
    <message>
        <source>a list of a number for each two names</source>
        <translation>список с числом на каждую пару имён</translation>
    </message>
    <message>
        <source>it holds a number beyond all ranges</source>
        <translation>в нём есть число вне всяких пределов</translation>
    </message>
    <message>
        <source>it names %1, with commas between them, each with =COLUMN where the file calls it otherwise</source>
        <translation>перечисляются через запятую %1, каждое с =СТОЛБЕЦ, если в файле он назван иначе</translation>
    </message>
    <message>
        <source>sample rates</source>
        <translation>частоты дискретизации</translation>
    </message>
    <message>
        <source>starts</source>
        <translation>времена начала</translation>
    </message>
    <message>
        <source>first times</source>
        <translation>времена первых отсчётов</translation>
    </message>
    <message>
        <source>numbers of channels</source>
        <translation>числа каналов</translation>
    </message>
    <message>
        <source>orders of the channels</source>
        <translation>порядки каналов</translation>
    </message>
    <message>
        <source>units</source>
        <translation>единицы измерения</translation>
    </message>
    <message>
        <source>end of the one and beginning of the other</source>
        <translation>конец одной и начало другой</translation>
    </message>
    <message>
        <source>it begins %1 s after the piece before it</source>
        <translation>она начинается через %1 с после предыдущей части</translation>
    </message>
    <message>
        <source>Analyse it as a recording of its own</source>
        <translation>Обработайте её как отдельную запись</translation>
    </message>
    <message>
        <source>it would belong to several recordings. Name one for each in a measurement list</source>
        <translation>этот файл достался бы нескольким записям. Назовите для каждой свой в списке измерений</translation>
    </message>
    <message>
        <source>it is the channel that is read as C</source>
        <translation>это тот же канал, который читается как C</translation>
    </message>
    <message>
        <source>it is a piece already</source>
        <translation>эта часть уже названа</translation>
    </message>
    <message>
        <source>it is for files with both channels, not for a file for each channel</source>
        <translation>она для файлов с обоими каналами, а не для отдельного файла на каждый канал</translation>
    </message>
    <message>
        <source>C and D at different times (%1 to %2 s and %3 to %4 s)</source>
        <translation>C и D с разным временем (от %1 до %2 с и от %3 до %4 с)</translation>
    </message>
    <message>
        <source>C and D from different times, %1 and %2</source>
        <translation>C и D с разным временем начала, %1 и %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; differs from &quot;%2&quot; in line %3, and one value holds for all recordings of a set: tell the same, or give the row a set of its own</source>
        <translation>«%1» отличается от «%2» в строке %3, а значение у всех записей набора одно: укажите то же или дайте строке отдельный набор</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::AnalysisStore</name>
    <message>
        <source>show %1</source>
        <translation>показать %1</translation>
    </message>
    <message>
        <source>hide %1</source>
        <translation>скрыть %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>переименовать %1</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>удалить %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::AxisLimitsDialog</name>
    <message>
        <source>Limits of the axis of %1</source>
        <translation>Пределы шкалы %1</translation>
    </message>
    <message>
        <source>From</source>
        <translation>От</translation>
    </message>
    <message>
        <source>To</source>
        <translation>До</translation>
    </message>
    <message>
        <source>Empty: as the data are</source>
        <translation>Пусто: по данным</translation>
    </message>
    <message>
        <source>Empty: as the data are. Fit and Zoom back remove the limits.</source>
        <translation>Пусто: по данным. «Показать всё» и «Предыдущий масштаб» снимают пределы.</translation>
    </message>
    <message>
        <source>The upper end lies at or below the lower one.</source>
        <translation>Верхний предел не больше нижнего.</translation>
    </message>
    <message>
        <source>A logarithmic axis begins above zero.</source>
        <translation>Логарифмическая шкала начинается выше нуля.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::BatchCommands</name>
    <message>
        <source>Folder of recordings</source>
        <translation>Папка с записями</translation>
    </message>
    <message>
        <source>Folder of passports</source>
        <translation>Папка с паспортами</translation>
    </message>
    <message>
        <source>Folder for JSON files</source>
        <translation>Папка для файлов JSON</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::BatchForm</name>
    <message>
        <source>Choose…</source>
        <translation>Выбрать…</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>A measurement list (CSV), or a folder in which each file is a set of its own</source>
        <translation>Список измерений (CSV) или папка, в которой каждый файл — отдельный набор</translation>
    </message>
    <message>
        <source>List…</source>
        <translation>Список…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Папка…</translation>
    </message>
    <message>
        <source>A folder in which each file is a set of its own</source>
        <translation>Папка, в которой каждый файл — отдельный набор</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Результаты</translation>
    </message>
    <message>
        <source>The table that is written, CSV: as vybeg-cli batch writes it. Until it is whole, its rows are beside it, and nothing that is computed is lost.</source>
        <translation>Таблица CSV, такая же, какую пишет vybeg-cli batch. Пока она не закончена, её строки лежат рядом, и вычисленное не пропадает.</translation>
    </message>
    <message>
        <source>Passports</source>
        <translation>Паспорта</translation>
    </message>
    <message>
        <source>Optional. A folder with GYRO.json for the gyros: each set is compared with the one of its gyro.</source>
        <translation>Необязательно. Папка с файлами ГИРОСКОП.json: каждый набор сравнивается с паспортом своего гироскопа.</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>База данных</translation>
    </message>
    <message>
        <source>Optional. The results also go into this database of results, for the history.</source>
        <translation>Необязательно. Результаты заносятся и в эту базу данных, для истории.</translation>
    </message>
    <message>
        <source>JSON files</source>
        <translation>Файлы JSON</translation>
    </message>
    <message>
        <source>Optional. A folder that also gets the whole result of each set, as vybeg-cli identify writes it.</source>
        <translation>Необязательно. Папка, куда кладётся и полный результат каждого набора, как его пишет vybeg-cli identify.</translation>
    </message>
    <message>
        <source>Settings of the Analysis panel where the list has none</source>
        <translation>Настройки панели «Обработка», где их нет в списке</translation>
    </message>
    <message>
        <source>Range, filter, calibration and tolerances as they are now; otherwise the defaults of the command line</source>
        <translation>Диапазон, фильтр, калибровка и допуски, как они заданы сейчас; иначе — значения командной строки по умолчанию</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::BatchTable</name>
    <message>
        <source>waiting</source>
        <translation>ожидает</translation>
    </message>
    <message>
        <source>done</source>
        <translation>готово</translation>
    </message>
    <message>
        <source>no result</source>
        <translation>нет результата</translation>
    </message>
    <message>
        <source>structured</source>
        <translation>с калиброванными датчиками</translation>
    </message>
    <message>
        <source>free</source>
        <translation>свободная</translation>
    </message>
    <message>
        <source>white</source>
        <translation>белый</translation>
    </message>
    <message>
        <source>coloured</source>
        <translation>окрашенный</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>СКО</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::BatchWindow</name>
    <message>
        <source>Replace the results?</source>
        <translation>Заменить результаты?</translation>
    </message>
    <message>
        <source>%1 already exists. The new table replaces it when it is complete.</source>
        <translation>%1 уже существует. Новая таблица заменит его, когда будет закончена.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Остановлено.</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n set(s)</source>
        <translation>
            <numerusform>%1 из %n набора</numerusform>
            <numerusform>%1 из %n наборов</numerusform>
            <numerusform>%1 из %n наборов</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a result</source>
        <translation>
            <numerusform>без результата: %n</numerusform>
            <numerusform>без результата: %n</numerusform>
            <numerusform>без результата: %n</numerusform>
        </translation>
    </message>
    <message>
        <source>stopping…</source>
        <translation>останавливается…</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>осталось %1</translation>
    </message>
    <message>
        <source>Stop the batch?</source>
        <translation>Остановить пакетную обработку?</translation>
    </message>
    <message>
        <source>The batch is running. What is computed is kept beside the table, and Start with the same files goes on from there.</source>
        <translation>Идёт обработка. Вычисленное сохраняется рядом с таблицей; «Начать» с теми же файлами продолжит с этого места.</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Остановить и закрыть</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Продолжать</translation>
    </message>
    <message>
        <source>Batch of sets</source>
        <translation>Пакетная обработка</translation>
    </message>
    <message>
        <source>Compute every set of the list; rows of a stopped batch with the same files and options are kept</source>
        <translation>Вычислить все наборы списка; строки остановленной обработки с теми же файлами и параметрами сохраняются</translation>
    </message>
    <message>
        <source>Stop; what is computed is kept</source>
        <translation>Остановить; вычисленное сохраняется</translation>
    </message>
    <message>
        <source>Progress of the batch</source>
        <translation>Ход пакетной обработки</translation>
    </message>
    <message>
        <source>Results of the batch</source>
        <translation>Результаты пакетной обработки</translation>
    </message>
    <message>
        <source>A double click or Return opens the set in the main window</source>
        <translation>Двойной щелчок или Enter открывает набор в главном окне</translation>
    </message>
    <message>
        <source>About the chosen set</source>
        <translation>О выбранном наборе</translation>
    </message>
    <message>
        <source>Why the chosen set has no result, and its warnings</source>
        <translation>Почему у выбранного набора нет результата, и его предупреждения</translation>
    </message>
    <message>
        <source>Choose a set to see why it has no result, and its warnings.</source>
        <translation>Выберите набор: здесь будет указано, почему у него нет результата, и его предупреждения.</translation>
    </message>
    <message>
        <source>Open the set in the main window</source>
        <translation>Открыть набор в главном окне</translation>
    </message>
    <message>
        <source>Copy rows</source>
        <translation>Копировать строки</translation>
    </message>
    <message>
        <source>%1 already exists and is not a table of results: choose another name.</source>
        <translation>Файл %1 уже есть, и это не таблица результатов: выберите другое имя.</translation>
    </message>
    <message>
        <source>What is computed is kept: Start goes on from here.</source>
        <translation>Вычисленное сохранено: кнопка «Начать» продолжит отсюда.</translation>
    </message>
    <message>
        <source>This set has a result, and no warnings.</source>
        <translation>У этого набора есть результат; предупреждений нет.</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Начать</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>&amp;Остановить</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::CalibrationFields</name>
    <message>
        <source>Gain ratio κ</source>
        <translation>Отношение κ</translation>
    </message>
    <message>
        <source>Channel D is recorded as D/κ, the scaling below (30): κ = 1 for balanced channels.</source>
        <translation>Канал D записан как D/κ, масштабирование после (30): κ = 1 для уравненных каналов.</translation>
    </message>
    <message>
        <source>Constant in each channel, recording units; it is subtracted. The averages of (13), (15) presume none.</source>
        <translation>Постоянная составляющая каждого канала в единицах записи; вычитается. Усреднения (13), (15) её не предполагают.</translation>
    </message>
    <message>
        <source>Offset C, D</source>
        <translation>Сдвиг C, D</translation>
    </message>
    <message>
        <source>Offset of C</source>
        <translation>Сдвиг C</translation>
    </message>
    <message>
        <source>Offset of D</source>
        <translation>Сдвиг D</translation>
    </message>
    <message>
        <source>Delay of D</source>
        <translation>Задержка D</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>мкс</translation>
    </message>
    <message>
        <source>By how much channel D is sampled later than C. It would otherwise count as Δφ_CD of (9).</source>
        <translation>На сколько канал D опрашивается позже C. Иначе вошла бы в Δφ_CD из (9).</translation>
    </message>
    <message>
        <source>Angle zero</source>
        <translation>Нуль угла</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle of the first electrode, subtracted from θ_A of (2): the article counts the angle from there.</source>
        <translation>Угол первого электрода, вычитается из θ_A в (2): в статье угол отсчитывается от него.</translation>
    </message>
    <message>
        <source>Take the offsets from the signals</source>
        <translation>Сдвиги по самим сигналам</translation>
    </message>
    <message>
        <source>Each channel&apos;s mean over whole periods of the carrier</source>
        <translation>Среднее каждого канала по целому числу периодов несущей</translation>
    </message>
    <message>
        <source>Make gaps of lost samples</source>
        <translation>Пропуски на месте потерь</translation>
    </message>
    <message>
        <source>Where the recording check finds lost samples, as many missing ones are put in, so that time runs on behind them. Windows over them have no values.</source>
        <translation>Там, где проверка записи находит потерянные отсчёты, вставляется столько же отсутствующих, и время за ними идёт верно. Окна с ними остаются без значений.</translation>
    </message>
    <message>
        <source>κ ±</source>
        <translation>κ ±</translation>
    </message>
    <message>
        <source>How well the gain ratio is known: relative standard deviation.</source>
        <translation>Насколько точно известно отношение коэффициентов передачи: относительное СКО.</translation>
    </message>
    <message>
        <source>Tolerance of the gain ratio</source>
        <translation>Допуск отношения коэффициентов передачи</translation>
    </message>
    <message>
        <source>ppm</source>
        <translation>млн⁻¹</translation>
    </message>
    <message>
        <source>Tolerance of the sample rate</source>
        <translation>Допуск частоты дискретизации</translation>
    </message>
    <message>
        <source>Spread ±</source>
        <translation>Разброс ±</translation>
    </message>
    <message>
        <source>Of the decay rate between the recordings of a set, relative; of the split 2.5 times it, of the gain ratio a tenth of it. Empty: what two or three recordings cannot show.</source>
        <translation>Скорости затухания между записями набора, относительный; разночастотности — в 2,5 раза больше, отношения коэффициентов передачи — в десять раз меньше. Пусто: то, чего не показывают две или три записи.</translation>
    </message>
    <message>
        <source>Tolerance of the spread between recordings</source>
        <translation>Допуск разброса между записями</translation>
    </message>
    <message>
        <source>Of the recorder&apos;s sample rate, for absolute frequencies and decay times.</source>
        <translation>Частоты дискретизации регистратора: для абсолютных частот и времён затухания.</translation>
    </message>
    <message>
        <source>Clock ±</source>
        <translation>Часы ±</translation>
    </message>
    <message>
        <source>Non-orthogonality ε ±</source>
        <translation>Неортогон. ε ±</translation>
    </message>
    <message>
        <source>Non-orthogonality of the pick-offs: D holds sin ε of C.</source>
        <translation>Неортогональность датчиков: в D входит sin ε от C.</translation>
    </message>
    <message>
        <source>Tolerance of the non-orthogonality</source>
        <translation>Допуск неортогональности</translation>
    </message>
    <message>
        <source>Delay ±</source>
        <translation>Задержка ±</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>нс</translation>
    </message>
    <message>
        <source>Of D against C, beyond the delay above.</source>
        <translation>D относительно C сверх задержки, заданной выше.</translation>
    </message>
    <message>
        <source>Tolerance of the delay</source>
        <translation>Допуск задержки</translation>
    </message>
    <message>
        <source>Crosstalk ±</source>
        <translation>Проникание ±</translation>
    </message>
    <message>
        <source>Of C into D with its phase turned by 90 degrees, relative.</source>
        <translation>Проникание C в D со сдвигом фазы на 90 градусов, относительное.</translation>
    </message>
    <message>
        <source>Tolerance of the crosstalk</source>
        <translation>Допуск проникания</translation>
    </message>
    <message>
        <source>Phase drift ±</source>
        <translation>Уход фазы ±</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>рад</translation>
    </message>
    <message>
        <source>Of D against C over a recording, in proportion to time.</source>
        <translation>D относительно C за запись, пропорционально времени.</translation>
    </message>
    <message>
        <source>Tolerance of the phase drift</source>
        <translation>Допуск ухода фазы</translation>
    </message>
    <message>
        <source>Gain drift ±</source>
        <translation>Уход усил. ±</translation>
    </message>
    <message>
        <source>Of D against C over a recording, relative, in proportion to time.</source>
        <translation>D относительно C за запись, относительный, пропорционально времени.</translation>
    </message>
    <message>
        <source>Tolerance of the gain drift</source>
        <translation>Допуск ухода усиления</translation>
    </message>
    <message>
        <source>How well the channels and the clock are known, for u. Empty: the number in grey is assumed; 0: exact.</source>
        <translation>Точность каналов и часов, для u. Пусто: принимается число серым; 0: точно.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::CarrierFields</name>
    <message>
        <source>Carrier f₀</source>
        <translation>Несущая f₀</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>Carrier of the whole recording, around which each window looks for its ω by (7), (25). Empty: the peak common to both channels&apos; spectra.</source>
        <translation>Несущая частота всей записи, вокруг которой каждое окно ищет свою ω по (7), (25). Пусто: общий максимум спектров обоих каналов.</translation>
    </message>
    <message>
        <source>Look for the carrier between these frequencies. Empty: everywhere. Both are needed.</source>
        <translation>Искать несущую между этими частотами. Пусто: везде. Нужны обе границы.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Поиск</translation>
    </message>
    <message>
        <source>Search from</source>
        <translation>Поиск от</translation>
    </message>
    <message>
        <source>Search to</source>
        <translation>Поиск до</translation>
    </message>
    <message>
        <source>Zero-phase band-pass before everything, for raw recordings with other modes, hum or offset: (1) presumes signals of the second angular harmonic alone. Empty: none. Both are needed.</source>
        <translation>Полосовой фильтр без сдвига фазы перед всей обработкой, для необработанных записей с другими модами, наводкой сети или смещением: (1) предполагает только вторую угловую гармонику. Пусто: без фильтра. Нужны обе границы.</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фильтр</translation>
    </message>
    <message>
        <source>Filter from</source>
        <translation>Фильтр от</translation>
    </message>
    <message>
        <source>Filter to</source>
        <translation>Фильтр до</translation>
    </message>
    <message>
        <source>from</source>
        <translation>от</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>Both frequencies are needed.</source>
        <translation>Нужны обе частоты.</translation>
    </message>
    <message>
        <source>The second frequency must be above the first.</source>
        <translation>Вторая частота должна быть выше первой.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::CheckList</name>
    <message>
        <source>Only the worst</source>
        <translation>Только самые серьёзные</translation>
    </message>
    <message>
        <source>Recording check</source>
        <translation>Проверка записи</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>Recording check: reading…</source>
        <translation>Проверка записи: чтение…</translation>
    </message>
    <message>
        <source>Recording check: nothing found</source>
        <translation>Проверка записи: замечаний нет</translation>
    </message>
    <message numerus="yes">
        <source>Recording check: %n finding(s)</source>
        <translation>
            <numerusform>Проверка записи: %n замечание</numerusform>
            <numerusform>Проверка записи: %n замечания</numerusform>
            <numerusform>Проверка записи: %n замечаний</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ComparisonView</name>
    <message>
        <source>Compared with %1. Changed: by %2 uncertainties u of the difference or more; by chance in one comparison of 370.</source>
        <translation>Сравнение с %1. Изменился: от %2 неопределённостей u разности; случайно — в одном сравнении из 370.</translation>
    </message>
    <message>
        <source>%1 is open: identify the set to compare.</source>
        <translation>Открыт %1: идентифицируйте набор, чтобы сравнить.</translation>
    </message>
    <message>
        <source>Not comparable: %1</source>
        <translation>Несравнимо: %1</translation>
    </message>
    <message>
        <source>Comparison with the passport</source>
        <translation>Сравнение с паспортом</translation>
    </message>
    <message>
        <source>Frequencies change from</source>
        <translation>Частоты изменились от</translation>
    </message>
    <message>
        <source>Frequencies follow the temperature: smaller changes, in parts per million, are none of the gyro</source>
        <translation>Частоты следуют за температурой: меньшие изменения, в миллионных долях, — не изменения гироскопа</translation>
    </message>
    <message>
        <source>Tracks of the recordings and of the passport</source>
        <translation>Графики записей и паспорта</translation>
    </message>
    <message>
        <source>In the colours of the recordings; further from the background: the passport</source>
        <translation>Цвета — как у записей; более контрастные оттенки — паспорт</translation>
    </message>
    <message>
        <source>What to overlay</source>
        <translation>Что наложить</translation>
    </message>
    <message>
        <source>Amplitude of the working wave</source>
        <translation>Амплитуда рабочей волны</translation>
    </message>
    <message>
        <source>Amplitude of the quadrature wave</source>
        <translation>Амплитуда квадратурной волны</translation>
    </message>
    <message>
        <source>Wave angle</source>
        <translation>Угол волны</translation>
    </message>
    <message>
        <source>Close the passport</source>
        <translation>Закрыть паспорт</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::CursorTimes</name>
    <message>
        <source>A cursor stands where the analysis has no windows.</source>
        <translation>Курсор стоит там, где у расчёта нет окон.</translation>
    </message>
    <message>
        <source>B − A = %1 s, 1/|B − A| = %2 Hz</source>
        <translation>B − A = %1 с, 1/|B − A| = %2 Гц</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Time of cursor A</source>
        <translation>Время курсора A</translation>
    </message>
    <message>
        <source>Time of cursor B</source>
        <translation>Время курсора B</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Seconds from the start of the recording; empty: no cursor. The keys 1 and 2 in the plots set the cursors at the mouse, Shift and an arrow key move the last one, 0 removes both.</source>
        <translation>Секунды от начала записи; пусто — курсора нет. Клавиши 1 и 2 на графиках ставят курсоры под мышью, Shift со стрелкой сдвигает последний, 0 убирает оба.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::Document</name>
    <message>
        <source>import of %1</source>
        <translation>импорт %1</translation>
    </message>
    <message>
        <source>close %1</source>
        <translation>закрыть %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::DossierModel</name>
    <message>
        <source>the gyro&apos;s data</source>
        <translation>данные гироскопа</translation>
    </message>
    <message>
        <source>limits of the parameters</source>
        <translation>пределы параметров</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::DriftPage</name>
    <message>
        <source>The drift is being computed…</source>
        <translation>Дрейф вычисляется…</translation>
    </message>
    <message>
        <source>There is no drift: %1</source>
        <translation>Дрейфа нет: %1</translation>
    </message>
    <message>
        <source>Open whole-angle logs: a controller holds the amplitude while the wave turns by 180 degrees or more, and its angle is written down over the time. Here appear the drift against the angle with its harmonics, and, where the log has the efforts, the resonator&apos;s damping and split.</source>
        <translation>Откройте журналы интегрирующего режима: контроллер удерживает амплитуду, пока волна поворачивается на 180 градусов или больше, и её угол записывается по времени. Здесь появятся дрейф по углу с его гармониками, а если в журнале есть воздействия — затухание и разночастотность резонатора.</translation>
    </message>
    <message>
        <source>Drift of the angle</source>
        <translation>Дрейф угла</translation>
    </message>
    <message>
        <source>Resonator, from drift and efforts</source>
        <translation>Резонатор по дрейфу и воздействиям</translation>
    </message>
    <message>
        <source>The turn and the harmonics of the drift; of several logs each by itself, too. Ctrl+C copies the table</source>
        <translation>Поворот и гармоники дрейфа; если журналов несколько — и каждого в отдельности. Ctrl+C копирует таблицу</translation>
    </message>
    <message>
        <source>Ctrl+C copies the table</source>
        <translation>Ctrl+C копирует таблицу</translation>
    </message>
    <message>
        <source>Drift against the angle</source>
        <translation>Дрейф по углу</translation>
    </message>
    <message>
        <source>Drift of the wave angle less the turn of each log: means over ranges of the angle with their standard deviations, and the fitted harmonics with theirs as a band</source>
        <translation>Дрейф угла волны без самого поворота каждого журнала: средние на участках угла с их СКО и подогнанные гармоники с полосой СКО</translation>
    </message>
    <message>
        <source>Export result…</source>
        <translation>Экспорт результата…</translation>
    </message>
    <message>
        <source>The drift by angle as a table (CSV), or the whole result (JSON)</source>
        <translation>Дрейф по углу таблицей (CSV) или весь результат (JSON)</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::DriftPanel</name>
    <message>
        <source>turns</source>
        <translation>обороты</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Разделитель</translation>
    </message>
    <message>
        <source>What stands between the columns of a text file</source>
        <translation>Что стоит между столбцами текстового файла</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>запятая</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>точка с запятой</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>табуляция</translation>
    </message>
    <message>
        <source>spaces</source>
        <translation>пробелы</translation>
    </message>
    <message>
        <source>vertical bar</source>
        <translation>вертикальная черта</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Десятичный знак</translation>
    </message>
    <message>
        <source>Of the numbers in a text file</source>
        <translation>Чисел в текстовом файле</translation>
    </message>
    <message>
        <source>point</source>
        <translation>точка</translation>
    </message>
    <message>
        <source>Lines to skip</source>
        <translation>Пропустить строк</translation>
    </message>
    <message>
        <source>Lines of a text file above its first row of numbers</source>
        <translation>Строк текстового файла над первой строкой чисел</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Столбец времени</translation>
    </message>
    <message>
        <source>Column of a text file that is the time, counted from 1; 0: none</source>
        <translation>Столбец текстового файла, в котором время, считая с 1; 0: нет</translation>
    </message>
    <message>
        <source>Drop whole-angle logs of one gyro here</source>
        <translation>Перетащите сюда журналы интегрирующего режима одного гироскопа</translation>
    </message>
    <message>
        <source>Not in effect: %1</source>
        <translation>Не действует: %1</translation>
    </message>
    <message>
        <source>Whole-angle logs</source>
        <translation>Журналы интегрирующего режима</translation>
    </message>
    <message>
        <source>Logs of one gyro: its angle, written down while a controller holds the amplitude. Delete removes the chosen ones</source>
        <translation>Журналы одного гироскопа: угол волны, пока контроллер удерживает амплитуду. Delete убирает выбранные</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Открыть…</translation>
    </message>
    <message>
        <source>Open whole-angle logs</source>
        <translation>Открыть журналы интегрирующего режима</translation>
    </message>
    <message>
        <source>Text, NPZ, MAT or HDF5 with a column of the wave angle</source>
        <translation>Текст, NPZ, MAT или HDF5 со столбцом угла волны</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Убрать</translation>
    </message>
    <message>
        <source>Remove the chosen logs</source>
        <translation>Убрать выбранные журналы</translation>
    </message>
    <message>
        <source>The files stay; Undo takes it back</source>
        <translation>Файлы остаются; отмена возвращает журналы</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Столбцы</translation>
    </message>
    <message>
        <source>What the columns are: t, theta, amplitude and quadrature effort, each with =COLUMN, a name or a number, where the file calls it otherwise: t,theta=angle. Empty: by their names</source>
        <translation>Что в столбцах: t, theta, amplitude и quadrature (угол, воздействия на амплитуду и квадратуру), каждое с =СТОЛБЕЦ (имя или номер), если в файле он назван иначе: t,theta=угол. Пусто — по именам</translation>
    </message>
    <message>
        <source>by their names</source>
        <translation>по именам</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>Угол в</translation>
    </message>
    <message>
        <source>Unit of the angle, where the name of its column does not tell it</source>
        <translation>Единица угла, если её не указывает имя столбца</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>как в файле</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусах</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>радианах</translation>
    </message>
    <message>
        <source>Time in</source>
        <translation>Время в</translation>
    </message>
    <message>
        <source>Unit of the time in a text file</source>
        <translation>Единица времени в текстовом файле</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>мкс</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>нс</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Частота дискретизации</translation>
    </message>
    <message>
        <source>Rows a second, of a file without times</source>
        <translation>Строк в секунду — для файла без времени</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>κ ±</source>
        <translation>κ ±</translation>
    </message>
    <message>
        <source>How well the gain ratio of the channels is known: relative standard deviation. A gain error gives a wave that turns a fourth harmonic; u holds it. Grey: assumed; 0: exact</source>
        <translation>Насколько известно отношение коэффициентов передачи каналов: относительное СКО. Его ошибка даёт поворачивающейся волне четвёртую гармонику; она входит в u. Серое — принято; 0 — точно</translation>
    </message>
    <message>
        <source>Gain ratio of the logs’ channels ±</source>
        <translation>Отношение коэффициентов передачи каналов журналов ±</translation>
    </message>
    <message>
        <source>ε ±</source>
        <translation>ε ±</translation>
    </message>
    <message>
        <source>How well the non-orthogonality of the channels is known: standard deviation. Grey: assumed; 0: exact</source>
        <translation>Насколько известна неортогональность каналов: СКО. Серое — принято; 0 — точно</translation>
    </message>
    <message>
        <source>Non-orthogonality of the logs’ channels ±</source>
        <translation>Неортогональность каналов журналов ±</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::DriftStore</name>
    <message>
        <source>open whole-angle logs</source>
        <translation>открытие журналов</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>убрать %1</translation>
    </message>
    <message>
        <source>remove logs</source>
        <translation>убрать журналы</translation>
    </message>
    <message>
        <source>settings of the drift</source>
        <translation>настройки дрейфа</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ExportDialog</name>
    <message>
        <source>Settings of the analyses below the plots</source>
        <translation>Настройки расчётов под графиками</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копировать</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Сохранить…</translation>
    </message>
    <message>
        <source>Export plots</source>
        <translation>Экспорт графиков</translation>
    </message>
    <message>
        <source>Whether the figure holds this plot</source>
        <translation>Входит ли этот график в рисунок</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Графики</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>Of the figure on paper</source>
        <translation>Рисунка на бумаге</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Высота</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Разрешение</translation>
    </message>
    <message>
        <source>Pixels per inch of a PNG image; SVG and PDF are vectors and need none</source>
        <translation>Точек на дюйм в изображении PNG; SVG и PDF — векторные, им разрешение не нужно</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>точек/дюйм</translation>
    </message>
    <message>
        <source>No title</source>
        <translation>Без заголовка</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Заголовок</translation>
    </message>
    <message>
        <source>Above the plots; empty: none</source>
        <translation>Над графиками; пусто — без заголовка</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF, by the ending of the name</source>
        <translation>В PNG, SVG или PDF — по расширению имени</translation>
    </message>
    <message>
        <source>To the clipboard, as an image and as vectors</source>
        <translation>В буфер обмена — как изображение и как векторный рисунок</translation>
    </message>
    <message>
        <source>The figure as it will be</source>
        <translation>Рисунок, каким он будет</translation>
    </message>
    <message>
        <source>Choose at least one plot.</source>
        <translation>Выберите хотя бы один график.</translation>
    </message>
    <message>
        <source>At least %1 mm is needed for these plots.</source>
        <translation>Для этих графиков нужно не меньше %1 мм.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::FiguresView</name>
    <message>
        <source>Rim, drift and balance of the channels appear here when the resonator is identified.</source>
        <translation>Кромка, дрейф и баланс каналов появятся здесь после идентификации резонатора.</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Кромка</translation>
    </message>
    <message>
        <source>Drift function</source>
        <translation>Функция дрейфа</translation>
    </message>
    <message>
        <source>Channel balance, condition (30)</source>
        <translation>Баланс каналов, условие (30)</translation>
    </message>
    <message>
        <source>The rim from the side of the electrodes, clockwise from C: electrodes, the axes of the faster mode (θ_w) and of larger damping (θ_τ) as wide as their standard deviations, and the wave of each recording at its start, out of scale</source>
        <translation>Кромка со стороны электродов, по часовой стрелке от C: электроды, оси более высокочастотной моды (θ_w) и большего затухания (θ_τ) шириной в их СКО и волна каждой записи в её начале, не в масштабе</translation>
    </message>
    <message>
        <source>What the balance is drawn against</source>
        <translation>По какой оси показан баланс</translation>
    </message>
    <message>
        <source>over time</source>
        <translation>по времени</translation>
    </message>
    <message>
        <source>over the wave angle</source>
        <translation>по углу волны</translation>
    </message>
    <message>
        <source>Harmonics of the drift function</source>
        <translation>Гармоники функции дрейфа</translation>
    </message>
    <message>
        <source>Drift of the wave angle against the angle: measured points with their standard deviations, and the harmonics fitted to them with their combined uncertainty u as a band; dashed: by the fitted resonator. Without what the quadrature adds</source>
        <translation>Дрейф угла волны в зависимости от угла: измеренные точки с СКО и подогнанные гармоники с полосой суммарной неопределённости u; штриховая линия — найденный резонатор. Без вклада квадратуры</translation>
    </message>
    <message>
        <source>Zero within its band while the channels are balanced as the fit has them</source>
        <translation>Нуль в пределах полосы, пока каналы сбалансированы так, как в подгонке</translation>
    </message>
    <message>
        <source>Copy harmonics</source>
        <translation>Копировать гармоники</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::FileCommands</name>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation>Сохранить изменения?</translation>
    </message>
    <message>
        <source>The session has changes that are not saved.</source>
        <translation>В сеансе есть несохранённые изменения.</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Сохранить сеанс</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was opened here. Saving replaces its changes.</source>
        <translation>Другая программа изменила файл %1 после того, как он был открыт здесь. Сохранение заменит её изменения.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Заменить</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::FileQuestions</name>
    <message>
        <source>Open recordings</source>
        <translation>Открытые записи</translation>
    </message>
    <message>
        <source>Audio (%1)</source>
        <translation>Звук (%1)</translation>
    </message>
    <message>
        <source>Tables of numbers (%1)</source>
        <translation>Таблицы чисел (%1)</translation>
    </message>
    <message>
        <source>Arrays (%1)</source>
        <translation>Массивы (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
    <message>
        <source>Import a recording</source>
        <translation>Импорт записи</translation>
    </message>
    <message>
        <source>Files of the recording</source>
        <translation>Файлы записи</translation>
    </message>
    <message>
        <source>Compare with passport</source>
        <translation>Сравнение с паспортом</translation>
    </message>
    <message>
        <source>Passport (*.json)</source>
        <translation>Паспорт (*.json)</translation>
    </message>
    <message>
        <source>Export plots</source>
        <translation>Экспорт графиков</translation>
    </message>
    <message>
        <source>Export track</source>
        <translation>Экспорт результатов</translation>
    </message>
    <message>
        <source>Track (*.csv)</source>
        <translation>Ряд (*.csv)</translation>
    </message>
    <message>
        <source>Save passport</source>
        <translation>Сохранение паспорта</translation>
    </message>
    <message>
        <source>PNG image (*.png)</source>
        <translation>Изображение PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Чертёж SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Документ PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Recordings and sessions (%1)</source>
        <translation>Записи и сеансы (%1)</translation>
    </message>
    <message>
        <source>Sessions (%1)</source>
        <translation>Сеансы (%1)</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Где находится %1?</translation>
    </message>
    <message>
        <source>Save session</source>
        <translation>Сохранить сеанс</translation>
    </message>
    <message>
        <source>Session (*.vybeg)</source>
        <translation>Сеанс (*.vybeg)</translation>
    </message>
    <message>
        <source>Track for MATLAB (*.mat)</source>
        <translation>Ряд для MATLAB (*.mat)</translation>
    </message>
    <message>
        <source>Track, HDF5 (*.h5)</source>
        <translation>Ряд, HDF5 (*.h5)</translation>
    </message>
    <message>
        <source>Track for NumPy (*.npz)</source>
        <translation>Ряд для NumPy (*.npz)</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Сохранить отчёт</translation>
    </message>
    <message>
        <source>Open database</source>
        <translation>Открыть базу данных</translation>
    </message>
    <message>
        <source>Database of results (*.db *.sqlite)</source>
        <translation>База результатов (*.db *.sqlite)</translation>
    </message>
    <message>
        <source>New database</source>
        <translation>Новая база данных</translation>
    </message>
    <message>
        <source>Database of results (*.db)</source>
        <translation>База результатов (*.db)</translation>
    </message>
    <message>
        <source>Measurement list</source>
        <translation>Список измерений</translation>
    </message>
    <message>
        <source>Measurement list (*.csv *.txt)</source>
        <translation>Список измерений (*.csv *.txt)</translation>
    </message>
    <message>
        <source>Database of results</source>
        <translation>База данных результатов</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Результаты</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Таблица (*.csv)</translation>
    </message>
    <message>
        <source>Export history</source>
        <translation>Экспорт истории</translation>
    </message>
    <message>
        <source>Open logs</source>
        <translation>Открыть журналы</translation>
    </message>
    <message>
        <source>Logs (%1)</source>
        <translation>Журналы (%1)</translation>
    </message>
    <message>
        <source>Open whole-angle logs</source>
        <translation>Открыть журналы интегрирующего режима</translation>
    </message>
    <message>
        <source>Export drift</source>
        <translation>Экспорт дрейфа</translation>
    </message>
    <message>
        <source>Result (*.json)</source>
        <translation>Результат (*.json)</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::FindingsFlag</name>
    <message>
        <source>Axis crossings, gaps and windows without convergence of the chosen analysis appear here.</source>
        <translation>Здесь появятся проходы осей, пропуски и окна без сходимости выбранного расчёта.</translation>
    </message>
    <message>
        <source>%1: events are looked for when all windows are there.</source>
        <translation>%1: события ищутся, когда готовы все окна.</translation>
    </message>
    <message>
        <source>%1: no axis crossings, no gaps.</source>
        <translation>%1: проходов осей и пропусков нет.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n event(s)</source>
        <translation>
            <numerusform>%1: %n событие</numerusform>
            <numerusform>%1: %n события</numerusform>
            <numerusform>%1: %n событий</numerusform>
        </translation>
    </message>
    <message>
        <source>Findings and events</source>
        <translation>Замечания и события</translation>
    </message>
    <message>
        <source>Findings of the recording check and events of the chosen analysis; a click in their lists goes there</source>
        <translation>Замечания проверки записи и события выбранного расчёта; щелчок в списке показывает место</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>События</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t, с</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Что</translation>
    </message>
    <message>
        <source>Take the offsets from the signals</source>
        <translation>Взять сдвиги из сигналов</translation>
    </message>
    <message>
        <source>Filter %1 … %2 Hz</source>
        <translation>Фильтр %1 … %2 Гц</translation>
    </message>
    <message>
        <source>Analyse from %1 s</source>
        <translation>Обрабатывать с %1 с</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::GyroDialog</name>
    <message>
        <source>The gyro&apos;s data</source>
        <translation>Данные гироскопа</translation>
    </message>
    <message>
        <source>Kept in the session, and proposed for its report</source>
        <translation>Хранится в сеансе и предлагается для отчёта</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Заводской номер</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Оператор</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Примечание</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::HelpView</name>
    <message>
        <source>No page has “%1”.</source>
        <translation>Ни на одной странице нет «%1».</translation>
    </message>
    <message>
        <source>Vybeg help</source>
        <translation>Справка Vybeg</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Найти</translation>
    </message>
    <message>
        <source>Text to find in the help</source>
        <translation>Что найти в справке</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>Страница справки</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Вперёд</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Содержание</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::HistoryChoices</name>
    <message>
        <source>Gyro</source>
        <translation>Гироскоп</translation>
    </message>
    <message>
        <source>Gyro of the history</source>
        <translation>Гироскоп истории</translation>
    </message>
    <message>
        <source>Whose results are shown; the number of its results stands behind its name</source>
        <translation>Чьи результаты показаны; за именем стоит число результатов</translation>
    </message>
    <message>
        <source>All gyros</source>
        <translation>Все гироскопы</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>без имени</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Параметр</translation>
    </message>
    <message>
        <source>Parameter of the history</source>
        <translation>Параметр истории</translation>
    </message>
    <message>
        <source>Which of its parameters is shown</source>
        <translation>Какой его параметр показан</translation>
    </message>
    <message>
        <source>Against</source>
        <translation>По оси X</translation>
    </message>
    <message>
        <source>Axis of the history</source>
        <translation>Ось истории</translation>
    </message>
    <message>
        <source>The mean frequency follows the temperature of the resonator</source>
        <translation>Средняя частота следует за температурой резонатора</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Частота</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Порядок</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Базовых результатов</translation>
    </message>
    <message>
        <source>Baseline of the control charts</source>
        <translation>Базовые результаты контрольных карт</translation>
    </message>
    <message>
        <source>So many first results of the gyro set centre and limits of the charts</source>
        <translation>Столько первых результатов гироскопа задают центр и пределы карт</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::HistoryPage</name>
    <message>
        <source>A database keeps the results of a laboratory, of this window and of the command line, so that each parameter of a gyro can be followed. Open one, or make a new one.</source>
        <translation>База данных хранит результаты лаборатории, из этого окна и из командной строки, чтобы можно было следить за каждым параметром гироскопа. Откройте базу или создайте новую.</translation>
    </message>
    <message>
        <source>The database is being read…</source>
        <translation>База данных читается…</translation>
    </message>
    <message>
        <source>The database holds no results yet. Identify a resonator and add its result, or fill it from the command line.</source>
        <translation>В базе данных ещё нет результатов. Идентифицируйте резонатор и добавьте его результат или заполните базу из командной строки.</translation>
    </message>
    <message>
        <source>First open a database, or make a new one.</source>
        <translation>Сначала откройте базу данных или создайте новую.</translation>
    </message>
    <message>
        <source>First identify the resonator of a set, on the page Resonator.</source>
        <translation>Сначала идентифицируйте резонатор набора на странице «Резонатор».</translation>
    </message>
    <message>
        <source>The identified resonator of the current set into the database</source>
        <translation>Записать резонатор текущего набора в базу данных</translation>
    </message>
    <message>
        <source>Of the result %1 these recordings are not where they were: %2.</source>
        <translation>Записи результата %1 не найдены на прежнем месте: %2.</translation>
    </message>
    <message>
        <source>The settings of the result %1 cannot be read: the set has those of the panel Analysis.</source>
        <translation>Настройки результата %1 не читаются: у набора настройки панели «Обработка».</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Открыть…</translation>
    </message>
    <message>
        <source>Open a database</source>
        <translation>Открыть базу данных</translation>
    </message>
    <message>
        <source>A database of results, of this window or of the command line</source>
        <translation>База результатов из этого окна или из командной строки</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Новая…</translation>
    </message>
    <message>
        <source>Make a database</source>
        <translation>Создать базу данных</translation>
    </message>
    <message>
        <source>An empty database of results in a new file</source>
        <translation>Пустая база результатов в новом файле</translation>
    </message>
    <message>
        <source>Add this result…</source>
        <translation>Добавить результат…</translation>
    </message>
    <message>
        <source>Open its recordings</source>
        <translation>Открыть его записи</translation>
    </message>
    <message>
        <source>As a set, with the settings and conditions of the result; a double click on the point does the same</source>
        <translation>Набором, с настройками и условиями результата; то же делает двойной щелчок по точке</translation>
    </message>
    <message>
        <source>Values of the parameter</source>
        <translation>Значения параметра</translation>
    </message>
    <message>
        <source>Moving range</source>
        <translation>Скользящий размах</translation>
    </message>
    <message>
        <source>Weighted average</source>
        <translation>Взвешенное среднее</translation>
    </message>
    <message>
        <source>Distribution of the parameter</source>
        <translation>Распределение параметра</translation>
    </message>
    <message>
        <source>A click chooses a result, a double click opens its recordings; Left and Right go to its neighbours</source>
        <translation>Щелчок выбирает результат, двойной щелчок открывает его записи; стрелки влево и вправо ведут к соседним</translation>
    </message>
    <message>
        <source>How often each value occurs among the results shown</source>
        <translation>Как часто каждое значение встречается среди показанных результатов</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Экспорт…</translation>
    </message>
    <message>
        <source>Export the results shown</source>
        <translation>Экспорт показанных результатов</translation>
    </message>
    <message>
        <source>The results shown as a table (CSV), or as a report with the charts (PDF)</source>
        <translation>Показанные результаты таблицей (CSV) или отчётом с картами (PDF)</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ImportDialog</name>
    <message>
        <source>Import</source>
        <translation>Импорт</translation>
    </message>
    <message>
        <source>How to read %1</source>
        <translation>Как читать %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ImportFields</name>
    <message>
        <source>A number other than 0 is needed.</source>
        <translation>Нужно число, отличное от нуля.</translation>
    </message>
    <message>
        <source>16 bit integer</source>
        <translation>целые 16 бит</translation>
    </message>
    <message>
        <source>32 bit integer</source>
        <translation>целые 32 бита</translation>
    </message>
    <message>
        <source>32 bit float</source>
        <translation>вещественные 32 бита</translation>
    </message>
    <message>
        <source>64 bit float</source>
        <translation>вещественные 64 бита</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Порядок байтов</translation>
    </message>
    <message>
        <source>Channel C</source>
        <translation>Канал C</translation>
    </message>
    <message>
        <source>Channel D</source>
        <translation>Канал D</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Каналы</translation>
    </message>
    <message>
        <source>Counted from 1; a time column does not count</source>
        <translation>Счёт от 1; столбец времени не в счёт</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>Sample rate</source>
        <translation>Частота дискретизации</translation>
    </message>
    <message>
        <source>Sample type</source>
        <translation>Тип отсчётов</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Масштаб</translation>
    </message>
    <message>
        <source>Used where the file has no rate of its own</source>
        <translation>Действует, если в файле частота не указана</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Переменные</translation>
    </message>
    <message>
        <source>big endian</source>
        <translation>старший байт первым</translation>
    </message>
    <message>
        <source>little endian</source>
        <translation>младший байт первым</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>байт</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>из файла</translation>
    </message>
    <message>
        <source>the first that fit</source>
        <translation>первые подходящие</translation>
    </message>
    <message>
        <source>Above the first row of numbers</source>
        <translation>Над первой строкой чисел</translation>
    </message>
    <message>
        <source>By its content, or as what it is said to be</source>
        <translation>По содержимому или так, как указано</translation>
    </message>
    <message>
        <source>Bytes before the first sample</source>
        <translation>Байты перед первым отсчётом</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>Десятичный знак</translation>
    </message>
    <message>
        <source>Gives the sample rate and is no channel; all other columns are</source>
        <translation>Задаёт частоту дискретизации и не является каналом; остальные столбцы — каналы</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>Заголовок</translation>
    </message>
    <message>
        <source>How each sample is stored</source>
        <translation>Как хранится каждый отсчёт</translation>
    </message>
    <message>
        <source>Interleaved: a sample of each, then the next of each</source>
        <translation>Чередуются: по отсчёту каждого канала, затем по следующему</translation>
    </message>
    <message>
        <source>Lines to skip</source>
        <translation>Пропустить строк</translation>
    </message>
    <message>
        <source>Little endian: the lowest byte comes first</source>
        <translation>Младший байт первым: в файле он стоит раньше старшего</translation>
    </message>
    <message>
        <source>Names of the variables that hold C and D and, third, the rate, with commas between them</source>
        <translation>Имена переменных, в которых C и D и, третьей, частота дискретизации, через запятую</translation>
    </message>
    <message>
        <source>Of the numbers in the file</source>
        <translation>Чисел в файле</translation>
    </message>
    <message>
        <source>Of the samples, once they are scaled</source>
        <translation>Отсчётов после умножения на масштаб</translation>
    </message>
    <message>
        <source>Of the time column</source>
        <translation>Столбца времени</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Читать как</translation>
    </message>
    <message>
        <source>Recording units per count or per unit of the file</source>
        <translation>Единиц записи на единицу кода или единицу файла</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Разделитель</translation>
    </message>
    <message>
        <source>Time column</source>
        <translation>Столбец времени</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Единица</translation>
    </message>
    <message>
        <source>Unit of time</source>
        <translation>Единица времени</translation>
    </message>
    <message>
        <source>What stands between the columns</source>
        <translation>Что стоит между столбцами</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>automatic: %1</source>
        <translation>авто: %1</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>запятая</translation>
    </message>
    <message>
        <source>from the time column</source>
        <translation>из столбца времени</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>нужно указать</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>нс</translation>
    </message>
    <message>
        <source>point</source>
        <translation>точка</translation>
    </message>
    <message>
        <source>raw samples</source>
        <translation>отсчёты без заголовка</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>точка с запятой</translation>
    </message>
    <message>
        <source>spaces</source>
        <translation>пробелы</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>табуляция</translation>
    </message>
    <message>
        <source>text</source>
        <translation>текст</translation>
    </message>
    <message>
        <source>vertical bar</source>
        <translation>вертикальная черта</translation>
    </message>
    <message>
        <source>what it is by content</source>
        <translation>по содержимому</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>мкс</translation>
    </message>
    <message>
        <source>File of channel D</source>
        <translation>Файл канала D</translation>
    </message>
    <message>
        <source>Where each channel has a file of its own: its name, or its path</source>
        <translation>Если у каждого канала свой файл: его имя или путь</translation>
    </message>
    <message>
        <source>the same file</source>
        <translation>тот же файл</translation>
    </message>
    <message>
        <source>Further pieces</source>
        <translation>Следующие части</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Выбрать…</translation>
    </message>
    <message>
        <source>Where a recording is in pieces: the names or paths of the further ones, in their order, with commas between them</source>
        <translation>Если запись в нескольких частях: имена или пути следующих частей по порядку, через запятую</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ImportPreview</name>
    <message>
        <source>First rows</source>
        <translation>Первые строки</translation>
    </message>
    <message>
        <source>First samples</source>
        <translation>Первые отсчёты</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>отсчёты</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::Ledger</name>
    <message>
        <source>%1 Hz at %2 s</source>
        <translation>%1 Гц в момент %2 с</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>К полупериодам</translation>
    </message>
    <message>
        <source>Analyse again with a window of whole half-periods, which leaks least</source>
        <translation>Рассчитать снова с окном из целых полупериодов: утечка в нём наименьшая</translation>
    </message>
    <message>
        <source>Recordings and analyses</source>
        <translation>Записи и расчёты</translation>
    </message>
    <message>
        <source>The chosen row is what is analysed, measured and shown by the other pages. Space hides, Delete removes, F2 renames</source>
        <translation>Выбранная строка рассчитывается, измеряется и показывается на других страницах. Пробел скрывает, Delete удаляет, F2 переименовывает</translation>
    </message>
    <message>
        <source>Recording, analysis</source>
        <translation>Запись, расчёт</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>Алгоритм</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>Window, samples</source>
        <translation>Окно, отсчётов</translation>
    </message>
    <message>
        <source>Mean f, Hz</source>
        <translation>Средняя f, Гц</translation>
    </message>
    <message>
        <source>Weighted mean of the frequency f_cp over all valid windows ± its standard deviation: scatter between windows, leakage of algorithms 1 to 4, bounds of the search</source>
        <translation>Взвешенное среднее частоты f_cp по всем годным окнам ± его СКО: разброс между окнами, утечка алгоритмов 1–4, границы поиска</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Шум</translation>
    </message>
    <message>
        <source>Noise per sample and channel: residual of the windows, its degrees of freedom counted</source>
        <translation>Шум на отсчёт и канал: невязка в окнах с учётом числа степеней свободы</translation>
    </message>
    <message>
        <source>⚠</source>
        <translation>⚠</translation>
    </message>
    <message>
        <source>Warnings of the recording and the analysis</source>
        <translation>Предупреждения записи и расчёта</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Переименовать</translation>
    </message>
    <message>
        <source>Analyse again with its settings</source>
        <translation>Рассчитать снова с его настройками</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <source>Add to the set of the resonator</source>
        <translation>Добавить в набор резонатора</translation>
    </message>
    <message>
        <source>Import again…</source>
        <translation>Импортировать заново…</translation>
    </message>
    <message>
        <source>Copy the facts of the recording</source>
        <translation>Копировать сведения о записи</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::LedgerHead</name>
    <message>
        <source>mouse</source>
        <translation>мышь</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>trend</source>
        <translation>тренд</translation>
    </message>
    <message>
        <source>Values of the windows at cursor A</source>
        <translation>Значения окон у курсора A</translation>
    </message>
    <message>
        <source>Values of the windows at cursor B</source>
        <translation>Значения окон у курсора B</translation>
    </message>
    <message>
        <source>Differences of the windows at the cursors; without standard deviation where they share samples</source>
        <translation>Разности окон у курсоров; без СКО, если у окон есть общие отсчёты</translation>
    </message>
    <message>
        <source>Rates of the trends between the cursors, or frequencies of the beats</source>
        <translation>Скорости трендов между курсорами или частоты биений</translation>
    </message>
    <message>
        <source>line</source>
        <translation>прямая</translation>
    </message>
    <message>
        <source>beat</source>
        <translation>биения</translation>
    </message>
    <message>
        <source>Trend between the cursors</source>
        <translation>Тренд между курсорами</translation>
    </message>
    <message>
        <source>start</source>
        <translation>начало</translation>
    </message>
    <message>
        <source>Values of the windows at the mouse in the plots, with standard deviations; of the first ones while it is elsewhere</source>
        <translation>Значения окон под мышью на графиках, с СКО; пока она не на графиках — первых окон</translation>
    </message>
    <message>
        <source>A line is an exponential for the working wave; a beat is a damped sinusoid, or the sum of two modes of a resonator where none fits. Fitted by weighted least squares to the windows between the cursors that share no samples. Where they scatter more than their noise, the deviations grow by that.</source>
        <translation>Прямая для рабочей волны — экспонента; биения — затухающая синусоида, а где она не подходит — сумма двух мод резонатора. Взвешенный метод наименьших квадратов по окнам между курсорами, не имеющим общих отсчётов. Где разброс больше шума, СКО увеличены во столько же.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::LengthField</name>
    <message>
        <source>“%1” is neither a whole number nor a range as 6..600.</source>
        <translation>«%1» — не целое число и не диапазон вида 6..600.</translation>
    </message>
    <message>
        <source>A window has %1 samples at least and %2 at most.</source>
        <translation>В окне не меньше %1 и не больше %2 отсчётов.</translation>
    </message>
    <message>
        <source>A list of window lengths is needed, e.g. 6..600 or 6, 60.</source>
        <translation>Нужен список длин окна, например 6..600 или 6, 60.</translation>
    </message>
    <message>
        <source>At most %1 lengths are possible.</source>
        <translation>Возможно не больше %1 длин.</translation>
    </message>
    <message>
        <source>Window lengths, samples</source>
        <translation>Длины окон, отсчётов</translation>
    </message>
    <message>
        <source>Samples per window: numbers and ranges, e.g. 6, 22, 60..600. A range stands for 15 lengths in equal ratios.</source>
        <translation>Отсчётов в окне: числа и диапазоны, например 6, 22, 60..600. Диапазон означает 15 длин с равными отношениями.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::LimitsDialog</name>
    <message>
        <source>Limits of the parameters</source>
        <translation>Пределы параметров</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Не менее</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Не более</translation>
    </message>
    <message>
        <source>Empty: no limit</source>
        <translation>Пусто: без предела</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>не менее</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>не более</translation>
    </message>
    <message>
        <source>A parameter keeps its limits where its value with twice its uncertainty lies within them (✓, green), and breaks them where all of that lies beyond (✗, red). Between, or without a value, nothing is said (?).</source>
        <translation>Параметр соблюдает пределы, если его значение с удвоенной неопределённостью целиком лежит внутри них (✓, зелёный), и нарушает их, если целиком лежит за ними (✗, красный). Между ними или без значения заключения нет (?).</translation>
    </message>
    <message>
        <source>The greatest value lies below the least one.</source>
        <translation>Наибольшее значение меньше наименьшего.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::LogDialog</name>
    <message>
        <source>turns</source>
        <translation>обороты</translation>
    </message>
    <message>
        <source>Its columns are not known by their names: choose what they are.</source>
        <translation>По именам столбцы не распознаны: выберите, что в них.</translation>
    </message>
    <message>
        <source>A number is not possible: see the red field.</source>
        <translation>Недопустимое число: см. красное поле.</translation>
    </message>
    <message>
        <source>The file has no times: give its rows per second.</source>
        <translation>В файле нет времени: укажите число строк в секунду.</translation>
    </message>
    <message>
        <source>The file does not tell the unit of its angles: choose it.</source>
        <translation>Единица углов в файле не указана: выберите её.</translation>
    </message>
    <message>
        <source>The frequency of the reference is not in the file: give it.</source>
        <translation>Опорной частоты в файле нет: укажите её.</translation>
    </message>
    <message>
        <source>No data show the sign of Y: choose it.</source>
        <translation>Знак Y по данным не виден: выберите его.</translation>
    </message>
    <message>
        <source>No data show whether amplitudes are peak or rms values: choose it.</source>
        <translation>По данным не видно, амплитудные это значения или действующие: выберите.</translation>
    </message>
    <message>
        <source>A filter has a bandwidth: give it, or choose none.</source>
        <translation>У фильтра есть полоса: укажите её или выберите «нет».</translation>
    </message>
    <message>
        <source>The file has one channel: choose the file of channel D.</source>
        <translation>В файле один канал: выберите файл канала D.</translation>
    </message>
    <message>
        <source>Each file has one channel, and not each has its partner among them by its name: open the two files of one log at a time.</source>
        <translation>В каждом файле один канал, и не у каждого по имени есть пара среди них: открывайте по два файла одного журнала.</translation>
    </message>
    <message>
        <source>Open logs</source>
        <translation>Открыть журналы</translation>
    </message>
    <message>
        <source>Logs of the set</source>
        <translation>Журналы набора</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>выберите…</translation>
    </message>
    <message>
        <source>Columns are</source>
        <translation>В столбцах</translation>
    </message>
    <message>
        <source>What the log keeps. The frame of phasors is whose phase they are relative to</source>
        <translation>Что хранит журнал. У комплексных амплитуд — относительно чьей фазы они даны</translation>
    </message>
    <message>
        <source>powers E, R, S, Q</source>
        <translation>мощности E, R, S, Q</translation>
    </message>
    <message>
        <source>amplitudes a, b and the angle θ</source>
        <translation>амплитуды a, b и угол θ</translation>
    </message>
    <message>
        <source>phasors, one frequency</source>
        <translation>компл. амплитуды, одна частота</translation>
    </message>
    <message>
        <source>phasors, an oscillator that moves</source>
        <translation>компл. амплитуды, перестраиваемый генератор</translation>
    </message>
    <message>
        <source>phasors, each channel its own phase</source>
        <translation>компл. амплитуды, у каждого канала своя фаза</translation>
    </message>
    <message>
        <source>Named</source>
        <translation>Имена</translation>
    </message>
    <message>
        <source>The columns, with commas between them, each with =COLUMN, a name or a number, where the file calls it otherwise, as in Xc=3,Yc=4,Xd=5,Yd=6</source>
        <translation>Столбцы через запятую; если в файле столбец зовётся иначе, то с =СТОЛБЕЦ, именем или номером, как в Xc=3,Yc=4,Xd=5,Yd=6</translation>
    </message>
    <message>
        <source>Channel D in</source>
        <translation>Канал D в</translation>
    </message>
    <message>
        <source>The file of the other channel, with the same times</source>
        <translation>Файл другого канала с теми же моментами времени</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Выбрать файл</translation>
    </message>
    <message>
        <source>Unit of angles</source>
        <translation>Единица углов</translation>
    </message>
    <message>
        <source>Of θ, or of the phase columns</source>
        <translation>Угла θ или столбцов фазы</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусы</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>радианы</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Опора</translation>
    </message>
    <message>
        <source>Frequency of the reference, which the file does not tell</source>
        <translation>Опорная частота, которой в файле нет</translation>
    </message>
    <message>
        <source>Sign of Y</source>
        <translation>Знак Y</translation>
    </message>
    <message>
        <source>The signal is Re((X + iY) exp iωt), or Re((X − iY) exp iωt). No data show it, and the other sign is the resonator seen in a mirror</source>
        <translation>Сигнал — Re((X + iY) exp iωt) или Re((X − iY) exp iωt). По данным это не видно, а другой знак — это резонатор в зеркале</translation>
    </message>
    <message>
        <source>+: X + iY turns as the carrier does</source>
        <translation>+: X + iY вращается, как несущая</translation>
    </message>
    <message>
        <source>−: X + iY turns against it</source>
        <translation>−: X + iY вращается навстречу ей</translation>
    </message>
    <message>
        <source>Amplitudes</source>
        <translation>Амплитуды</translation>
    </message>
    <message>
        <source>What √(X² + Y²) is</source>
        <translation>Что такое √(X² + Y²)</translation>
    </message>
    <message>
        <source>peak values</source>
        <translation>амплитудные значения</translation>
    </message>
    <message>
        <source>rms values</source>
        <translation>действующие значения</translation>
    </message>
    <message>
        <source>Filter, stages</source>
        <translation>Фильтр, звенья</translation>
    </message>
    <message>
        <source>RC stages of the lock-in&apos;s filter: it delays the phasors and correlates their noise</source>
        <translation>Звенья RC фильтра синхронного детектора: он задерживает комплексные амплитуды и коррелирует их шум</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Its bandwidth</source>
        <translation>Его полоса</translation>
    </message>
    <message>
        <source>3 dB</source>
        <translation>По уровню 3 дБ</translation>
    </message>
    <message>
        <source>Rows a second</source>
        <translation>Строк в секунду</translation>
    </message>
    <message>
        <source>Where the file has no times, or ticks of a clock</source>
        <translation>Если в файле нет времени или даны такты</translation>
    </message>
    <message>
        <source>Leave out until</source>
        <translation>Пропустить до</translation>
    </message>
    <message>
        <source>Time from the start of a log: what is before it is left out, as the settling of a filter</source>
        <translation>Время от начала журнала: что раньше, не учитывается, например установление фильтра</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Открыть</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Looking at the files…</source>
        <translation>Файлы просматриваются…</translation>
    </message>
    <message>
        <source>There is no log: drop some into the list.</source>
        <translation>Журналов нет: перетащите их в список.</translation>
    </message>
    <message>
        <source>%1 Delete removes it from the list of logs.</source>
        <translation>%1 Delete убирает его из списка журналов.</translation>
    </message>
    <message>
        <source>Each file has one channel: choose the one of channel D.</source>
        <translation>В каждом файле один канал: выберите, в каком канал D.</translation>
    </message>
    <message>
        <source>%1 is no file: choose the file of channel D.</source>
        <translation>%1 — не файл: выберите файл канала D.</translation>
    </message>
    <message>
        <source>Logs</source>
        <translation>Журналы</translation>
    </message>
    <message>
        <source>Logs of one resonator, made alike. Delete removes the chosen ones</source>
        <translation>Журналы одного резонатора, записанные одинаково. Delete убирает выбранные</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::LogFiles</name>
    <message>
        <source>Drop logs of one resonator here</source>
        <translation>Перетащите сюда журналы одного резонатора</translation>
    </message>
    <message>
        <source>%1 — cannot be opened so</source>
        <translation>%1 — так не открыть</translation>
    </message>
    <message>
        <source>%1 — channel C</source>
        <translation>%1 — канал C</translation>
    </message>
    <message>
        <source>%1 — channel D of %2</source>
        <translation>%1 — канал D к %2</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>Инструменты</translation>
    </message>
    <message>
        <source>No recording is open, and this page is about recordings. Open are:</source>
        <translation>Записи не открыты, а эта страница — о записях. Открыто:</translation>
    </message>
    <message>
        <source>%1: page %2</source>
        <translation>%1: страница %2</translation>
    </message>
    <message>
        <source>whole-angle logs %1: page %2</source>
        <translation>журналы интегрирующего режима %1: страница %2</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::MessageBar</name>
    <message numerus="yes">
        <source>%n more message(s)</source>
        <translation>
            <numerusform>Ещё %n сообщение</numerusform>
            <numerusform>Ещё %n сообщения</numerusform>
            <numerusform>Ещё %n сообщений</numerusform>
        </translation>
    </message>
    <message>
        <source>Close all</source>
        <translation>Закрыть все</translation>
    </message>
    <message>
        <source>Closes all messages but questions</source>
        <translation>Закрывает все сообщения, кроме вопросов</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Закрыть это сообщение</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Импорт…</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Свернуть</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Ещё</translation>
    </message>
    <message>
        <source>Leaves one line of the newest message</source>
        <translation>Оставляет одну строку последнего сообщения</translation>
    </message>
    <message>
        <source>Shows whole messages, over the window</source>
        <translation>Показывает сообщения целиком поверх окна</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::NumberField</name>
    <message>
        <source>A number is needed.</source>
        <translation>Нужно число.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«%1» — не число.</translation>
    </message>
    <message>
        <source>A whole number is needed.</source>
        <translation>Нужно целое число.</translation>
    </message>
    <message>
        <source>A number above zero is needed.</source>
        <translation>Нужно число больше нуля.</translation>
    </message>
    <message>
        <source>At least %1 is needed.</source>
        <translation>Нужно не меньше %1.</translation>
    </message>
    <message>
        <source>At most %1 is possible.</source>
        <translation>Нужно не больше %1.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::NumbersView</name>
    <message>
        <source>Modes</source>
        <translation>Моды</translation>
    </message>
    <message>
        <source>Modes, by decay</source>
        <translation>Моды, по затуханию</translation>
    </message>
    <message>
        <source>Modes, by frequency</source>
        <translation>Моды, по частоте</translation>
    </message>
    <message>
        <source>Motion of the waves</source>
        <translation>Поведение волн</translation>
    </message>
    <message>
        <source>Resonator</source>
        <translation>Резонатор</translation>
    </message>
    <message>
        <source>Ctrl+C copies the table</source>
        <translation>Ctrl+C копирует таблицу</translation>
    </message>
    <message>
        <source>What the wave of each recording did, free of the model</source>
        <translation>Что делала волна каждой записи, независимо от модели</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>Frequencies and decay times of both modes</source>
        <translation>Частоты и времена затухания обеих мод</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Чувствительность</translation>
    </message>
    <message>
        <source>By how much errors of a usual size would falsify a value</source>
        <translation>Насколько обычные погрешности исказили бы значение</translation>
    </message>
    <message>
        <source>Less</source>
        <translation>Короче</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Допуски</translation>
    </message>
    <message>
        <source>What the wave of each recording did, and what the fit found of it</source>
        <translation>Что делала волна каждой записи и что о ней нашла подгонка</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>Страницы</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::PassportStore</name>
    <message>
        <source>open the passport</source>
        <translation>открытие паспорта</translation>
    </message>
    <message>
        <source>close the passport</source>
        <translation>закрытие паспорта</translation>
    </message>
    <message>
        <source>limit of the frequencies&apos; changes</source>
        <translation>предел изменения частот</translation>
    </message>
    <message>
        <source>The session&apos;s passport cannot be opened: %1 The results are shown without the comparison.</source>
        <translation>Паспорт сеанса открыть нельзя: %1 Результаты показаны без сравнения.</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Найти…</translation>
    </message>
    <message>
        <source>%1 is another passport than that of the session: its SHA-256 differs. The results are compared with the present one.</source>
        <translation>%1 — не тот паспорт, что указан в сеансе: его SHA-256 отличается. Результаты сравниваются с нынешним.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::PlotView</name>
    <message>
        <source>Copy plot</source>
        <translation>Копировать график</translation>
    </message>
    <message>
        <source>Export plot…</source>
        <translation>Экспорт графика…</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::QuantityTable</name>
    <message>
        <source>sd</source>
        <translation>СКО</translation>
    </message>
    <message>
        <source>value</source>
        <translation>значение</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Копировать таблицу</translation>
    </message>
    <message>
        <source>u</source>
        <translation>u</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::RangeFields</name>
    <message>
        <source>From, to</source>
        <translation>От, до</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Part of the recording to analyse, from its start.</source>
        <translation>Обрабатываемый участок, от начала записи.</translation>
    </message>
    <message>
        <source>Range from</source>
        <translation>Участок от</translation>
    </message>
    <message>
        <source>Range to</source>
        <translation>Участок до</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Вся запись</translation>
    </message>
    <message>
        <source>Analyse the whole recording</source>
        <translation>Обработать всю запись</translation>
    </message>
    <message>
        <source>As visible</source>
        <translation>Видимый участок</translation>
    </message>
    <message>
        <source>Analyse the time range that the plots show</source>
        <translation>Обработать интервал, который виден на графиках</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::RecentFiles</name>
    <message>
        <source>Clear this list</source>
        <translation>Очистить список</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::RecordingStore</name>
    <message numerus="yes">
        <source>%n more finding(s) in the recording check.</source>
        <translation>
            <numerusform>В проверке записи ещё %n замечание.</numerusform>
            <numerusform>В проверке записи ещё %n замечания.</numerusform>
            <numerusform>В проверке записи ещё %n замечаний.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ReportDialog</name>
    <message>
        <source>All plots, also phase, noise and orthogonality</source>
        <translation>Все графики, также фаза, шум и ортогональность</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Отчёт</translation>
    </message>
    <message>
        <source>Report of</source>
        <translation>Отчёт о</translation>
    </message>
    <message>
        <source>A recording, a set of them with its resonator, or all sets</source>
        <translation>Запись, набор записей с его резонатором или все наборы</translation>
    </message>
    <message>
        <source>Empty: a line to fill in by hand</source>
        <translation>Пусто: строка для заполнения от руки</translation>
    </message>
    <message>
        <source>Off: the five slow variables</source>
        <translation>Выключено: пять медленных переменных</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Сохранить…</translation>
    </message>
    <message>
        <source>As a PDF document</source>
        <translation>Как документ PDF</translation>
    </message>
    <message>
        <source>One page to be signed: result, limits, warnings</source>
        <translation>Одна страница на подпись: результат, пределы, предупреждения</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ResidualsPage</name>
    <message>
        <source>The residual appears when all windows of the analysis are there.</source>
        <translation>Невязка появится, когда будут готовы все окна расчёта.</translation>
    </message>
    <message>
        <source>The residual is being computed…</source>
        <translation>Невязка вычисляется…</translation>
    </message>
    <message>
        <source>No sample of this range has a wave: samples are missing, the wave is circular, or the range lies outside the analysed one.</source>
        <translation>На этом участке нет отсчётов с волной: отсчёты пропущены, волна круговая или участок лежит вне обработанного.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) above the noise: choose one</source>
        <translation>
            <numerusform>%n линия выше шума: выберите</numerusform>
            <numerusform>%n линии выше шума: выберите</numerusform>
            <numerusform>%n линий выше шума: выберите</numerusform>
        </translation>
    </message>
    <message>
        <source>No line above the noise.</source>
        <translation>Выше шума линий нет.</translation>
    </message>
    <message>
        <source>The range is too short for this plot.</source>
        <translation>Для этого графика участок слишком короткий.</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>Фильтр %1</translation>
    </message>
    <message>
        <source>Residual of</source>
        <translation>Невязка:</translation>
    </message>
    <message>
        <source>the window at the cursor</source>
        <translation>окно под курсором</translation>
    </message>
    <message>
        <source>the visible part</source>
        <translation>видимая часть</translation>
    </message>
    <message>
        <source>the whole analysis</source>
        <translation>весь расчёт</translation>
    </message>
    <message>
        <source>Range of the residual</source>
        <translation>Участок невязки</translation>
    </message>
    <message>
        <source>Samples less the wave of their window: of one window, of what the plots of the tracks show, or of all</source>
        <translation>Отсчёты за вычетом волны их окна: одного окна, того, что показывают графики рядов, или всего расчёта</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Time of the window</source>
        <translation>Время окна</translation>
    </message>
    <message>
        <source>The window nearest to this time, which cursor A or the mouse over the tracks sets, too</source>
        <translation>Окно, ближайшее к этому времени; его задают также курсор A и мышь над рядами</translation>
    </message>
    <message>
        <source>Lines above the noise</source>
        <translation>Линии выше шума</translation>
    </message>
    <message>
        <source>Peaks that rise above the noise around them; white noise shows one in one of a hundred spectra</source>
        <translation>Пики, поднимающиеся над шумом вокруг них; белый шум даёт такой пик в одном спектре из ста</translation>
    </message>
    <message>
        <source>Puts this band-pass into the panel Analysis; Undo takes it back</source>
        <translation>Записывает этот полосовой фильтр на панель «Обработка»; отмена возвращает прежние настройки</translation>
    </message>
    <message>
        <source>Spectrum of the residual</source>
        <translation>Спектр невязки</translation>
    </message>
    <message>
        <source>A click on a line names it; Left and Right go from line to line</source>
        <translation>Щелчок называет линию; клавиши «влево» и «вправо» переходят от линии к линии</translation>
    </message>
    <message>
        <source>Distribution of the residual</source>
        <translation>Распределение невязки</translation>
    </message>
    <message>
        <source>Autocorrelation of the residual</source>
        <translation>Автокорреляция невязки</translation>
    </message>
    <message>
        <source>Of white noise, 95 % of the lags lie between the dashed lines</source>
        <translation>У белого шума 95 % значений лежат между штриховыми линиями</translation>
    </message>
    <message>
        <source>Numbers of the residual</source>
        <translation>Числа невязки</translation>
    </message>
    <message>
        <source>Against the normal curve of the same standard deviation</source>
        <translation>Рядом с нормальной кривой с тем же СКО</translation>
    </message>
    <message>
        <source>Ctrl+C copies the table</source>
        <translation>Ctrl+C копирует таблицу</translation>
    </message>
    <message>
        <source>No analysis is chosen. Keep (F5) adds one of the current recording; a row of the table below chooses one.</source>
        <translation>Расчёт не выбран. «Закрепить» (F5) добавит расчёт текущей записи; строка таблицы внизу выбирает его.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::ResonatorPage</name>
    <message>
        <source>Nothing identified yet.</source>
        <translation>Пока ничего не идентифицировано.</translation>
    </message>
    <message>
        <source>Open recordings of a free decay to identify the resonator.</source>
        <translation>Откройте записи выбега, чтобы идентифицировать резонатор.</translation>
    </message>
    <message>
        <source>Out of date.</source>
        <translation>Устарело.</translation>
    </message>
    <message>
        <source>The set or its settings have changed since: identify again.</source>
        <translation>Набор или его параметры с тех пор изменились: идентифицируйте снова.</translation>
    </message>
    <message>
        <source>⚠ Without these recordings of the measurement list: %1.</source>
        <translation>⚠ Без этих записей списка измерений: %1.</translation>
    </message>
    <message>
        <source>Being identified…</source>
        <translation>Идентифицируется…</translation>
    </message>
    <message>
        <source>Channel balance</source>
        <translation>Баланс каналов</translation>
    </message>
    <message>
        <source>Condition (30) of the article, recording by recording</source>
        <translation>Условие (30) статьи, для каждой записи</translation>
    </message>
    <message>
        <source>Passport</source>
        <translation>Паспорт</translation>
    </message>
    <message>
        <source>What has changed since the passport was made</source>
        <translation>Что изменилось после составления паспорта</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n recording(s)</source>
        <translation>
            <numerusform>%1; %n запись</numerusform>
            <numerusform>%1; %n записи</numerusform>
            <numerusform>%1; %n записей</numerusform>
        </translation>
    </message>
    <message>
        <source>Result of the session, identified by %1 from %2. %3. The motion of the waves, the plots and the report need the recordings.</source>
        <translation>Результат из сеанса, вычислен программой %1 по записям %2. %3. Для движения волн, графиков и отчёта нужны сами записи.</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::Section</name>
    <message>
        <source>Folds this part away, and opens it again</source>
        <translation>Сворачивает и разворачивает этот раздел</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SessionKeeper</name>
    <message>
        <source>%1 is not a session that can be read: it is no JSON at byte %2.</source>
        <translation>%1 — не сеанс, который можно прочитать: в байте %2 это не JSON.</translation>
    </message>
    <message>
        <source>%1 is not a session of Vybeg.</source>
        <translation>%1 — не сеанс Vybeg.</translation>
    </message>
    <message>
        <source>%1 was written by a later version of Vybeg. What this version does not know of it is kept, but not shown.</source>
        <translation>Файл %1 записан более новой версией Vybeg. Неизвестное этой версии сохраняется, но не показывается.</translation>
    </message>
    <message>
        <source>The session&apos;s recording %1 is not there. The session keeps its place and its analyses.</source>
        <translation>Записи %1, входящей в сеанс, нет на месте. Сеанс хранит её место и её расчёты.</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Найти…</translation>
    </message>
    <message>
        <source>%1 is another file than that of the session: its SHA-256 differs. The analyses are computed from the present file.</source>
        <translation>%1 — не тот файл, что был в сеансе: SHA-256 отличается. Расчёты выполнены по нынешнему файлу.</translation>
    </message>
    <message numerus="yes">
        <source>A session was not closed, and can be recovered: %1, %n recording(s), %2.</source>
        <translation>
            <numerusform>Сеанс не был закрыт, его можно восстановить: %1, %n запись, %2.</numerusform>
            <numerusform>Сеанс не был закрыт, его можно восстановить: %1, %n записи, %2.</numerusform>
            <numerusform>Сеанс не был закрыт, его можно восстановить: %1, %n записей, %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Восстановить</translation>
    </message>
    <message>
        <source>The session %1 is damaged: “%2” holds something else than a session has there. Restore the file from a copy.</source>
        <translation>Сеанс %1 повреждён: в «%2» записано не то, что бывает в сеансе. Восстановите файл из копии.</translation>
    </message>
    <message>
        <source>The session %1 cannot be opened: %2 Open it with the version of Vybeg that wrote it, or restore the file from a copy.</source>
        <translation>Сеанс %1 не открывается: %2 Откройте его той версией Vybeg, которая его записала, или восстановите файл из копии.</translation>
    </message>
    <message numerus="yes">
        <source>Session %1 of %2 that were not closed: %3, %n recording(s), %4.</source>
        <translation>
            <numerusform>Сеанс %1 из %2 незакрытых: %3, %n запись, %4.</numerusform>
            <numerusform>Сеанс %1 из %2 незакрытых: %3, %n записи, %4.</numerusform>
            <numerusform>Сеанс %1 из %2 незакрытых: %3, %n записей, %4.</numerusform>
        </translation>
    </message>
    <message>
        <source>Another…</source>
        <translation>Другой…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Забыть</translation>
    </message>
    <message>
        <source>The copy of the session stays: %1</source>
        <translation>Копия сеанса остаётся: %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SetPanel</name>
    <message>
        <source>New set</source>
        <translation>Новый набор</translation>
    </message>
    <message>
        <source>Remove the set</source>
        <translation>Убрать набор</translation>
    </message>
    <message>
        <source>Remove the set; its recordings stay open</source>
        <translation>Убрать набор; его записи остаются открытыми</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
    <message>
        <source>Model of the resonator</source>
        <translation>Модель резонатора</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматически</translation>
    </message>
    <message>
        <source>Structured, unless the free model fits significantly better</source>
        <translation>С калиброванными датчиками, если свободная не подходит значимо лучше</translation>
    </message>
    <message>
        <source>The channels are the cosine and sine of the standing wave: split, axes, damping</source>
        <translation>Каналы — косинус и синус стоячей волны: разночастотность, оси, затухание</translation>
    </message>
    <message>
        <source>The channels are any two views of the modes, as with a bell: their frequencies and decay times</source>
        <translation>Каналы — две любые проекции мод, как у колокола: их частоты и времена затухания</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Идентифицировать</translation>
    </message>
    <message>
        <source>What the fit assumes of the channels</source>
        <translation>Что модель предполагает о каналах</translation>
    </message>
    <message>
        <source>Settings and conditions come from the measurement list and from offers accepted since; the panel Analysis does not change them.</source>
        <translation>Настройки и условия взяты из списка измерений и принятых затем предложений; панель «Обработка» их не меняет.</translation>
    </message>
    <message>
        <source>Drop recordings of one resonator here, best started at four angles</source>
        <translation>Перетащите сюда записи одного резонатора, лучше всего начатые под четырьмя углами</translation>
    </message>
    <message>
        <source>Fit one resonator to all recordings of the set; of an empty set, to the current recording and those opened together with it (F7)</source>
        <translation>Подобрать один резонатор по всем записям набора; если набор пуст — по текущей записи и открытым вместе с ней (F7)</translation>
    </message>
    <message>
        <source>Logs, read with %1.</source>
        <translation>Журналы, прочитаны с %1.</translation>
    </message>
    <message>
        <source>Calibration and tolerances are those of the panel Analysis, which stands beside the page Tracks.</source>
        <translation>Калибровка и допуски взяты из панели «Обработка», которая стоит у страницы «Ряды».</translation>
    </message>
    <message>
        <source>Drop logs of the resonator here</source>
        <translation>Перетащите сюда журналы резонатора</translation>
    </message>
    <message>
        <source>Logs…</source>
        <translation>Журналы…</translation>
    </message>
    <message>
        <source>Add logs to the set, remove some, or tell otherwise what they are</source>
        <translation>Добавить журналы в набор, убрать их или указать иначе, что в них</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Наборы</translation>
    </message>
    <message>
        <source>Sets of recordings</source>
        <translation>Наборы записей</translation>
    </message>
    <message>
        <source>Each with its recordings: those that are checked are of one resonator and are identified together. A check mark behind their number: identified. F2 names a set; Delete removes a recording or a set</source>
        <translation>Каждый со своими записями: отмеченные принадлежат одному резонатору и идентифицируются вместе. Галочка после их числа: набор идентифицирован. F2 — назвать набор; Delete — убрать запись или набор</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 logs</source>
        <translation>журналов: %1</translation>
    </message>
    <message>
        <source>%1 rec.</source>
        <translation>%1 зап.</translation>
    </message>
    <message>
        <source>Structured</source>
        <translation>С калиброванными датчиками</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Свободная</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SetStore</name>
    <message>
        <source>new set</source>
        <translation>новый набор</translation>
    </message>
    <message>
        <source>remove the set</source>
        <translation>удалить набор</translation>
    </message>
    <message>
        <source>rename the set</source>
        <translation>переименовать набор</translation>
    </message>
    <message>
        <source>model of the set</source>
        <translation>модель набора</translation>
    </message>
    <message>
        <source>recordings of the set</source>
        <translation>записи набора</translation>
    </message>
    <message>
        <source>sets of the list</source>
        <translation>наборы списка</translation>
    </message>
    <message>
        <source>The set %1 of the list names these recordings more than once: %2. Each counts once.</source>
        <translation>Набор %1 списка называет эти записи более одного раза: %2. Каждая учитывается один раз.</translation>
    </message>
    <message>
        <source>open logs</source>
        <translation>открыть журналы</translation>
    </message>
    <message>
        <source>calibration of the set</source>
        <translation>калибровка набора</translation>
    </message>
    <message>
        <source>logs of the set</source>
        <translation>журналы набора</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SettingsFields</name>
    <message>
        <source>Not in effect: %1</source>
        <translation>Не действует: %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SettingsModel</name>
    <message>
        <source>tolerances of the channels</source>
        <translation>допуски каналов</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SettingsPanel</name>
    <message>
        <source>Window</source>
        <translation>Окно</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Участок</translation>
    </message>
    <message>
        <source>Carrier and filter</source>
        <translation>Несущая и фильтр</translation>
    </message>
    <message>
        <source>Start values</source>
        <translation>Начальное приближение</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Калибровка</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>Алгоритм</translation>
    </message>
    <message>
        <source>Analyse the current recording with these settings and keep the analysis (F5)</source>
        <translation>Обработать текущую запись с этими настройками и оставить расчёт в списке (F5)</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Автопересчёт</translation>
    </message>
    <message>
        <source>Every change of a setting shows at once: first in the visible part of the plots, then in the rest, always in the same analysis. What is to stay for comparison is kept by Keep, F5 (Ctrl+L)</source>
        <translation>Каждое изменение настройки сразу видно: сначала на видимой части графиков, затем на остальной, всегда в одном и том же расчёте. То, что нужно для сравнения, оставляет «Закрепить», F5 (Ctrl+L)</translation>
    </message>
    <message>
        <source>The plots are older than these settings. Changed since: %1.</source>
        <translation>Графики старше этих настроек. С тех пор изменено: %1.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Закрепить</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SignalView</name>
    <message>
        <source>Overview of the recording</source>
        <translation>Обзор записи</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>чтение…</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Analysed range: drag the ends of the bar</source>
        <translation>Обрабатываемый участок: тяните за концы полосы</translation>
    </message>
    <message>
        <source>Visible range: drag the edges, or the inside to shift it</source>
        <translation>Видимый интервал: тяните за края, а за середину — для сдвига</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SignalsPage</name>
    <message>
        <source>The residual is what an analysis leaves of the samples.</source>
        <translation>Невязка — то, что расчёт оставляет от отсчётов.</translation>
    </message>
    <message>
        <source>No recording is open.</source>
        <translation>Нет открытых записей.</translation>
    </message>
    <message>
        <source>The recording %1 is being opened…</source>
        <translation>Запись %1 открывается…</translation>
    </message>
    <message>
        <source>%1, samples as recorded. Keep (F5) fits the wave.</source>
        <translation>%1, отсчёты как записаны. «Закрепить» (F5) подгоняет волну.</translation>
    </message>
    <message>
        <source>%1: the wave appears when all windows of the analysis are there.</source>
        <translation>%1: волна появится, когда будут готовы все окна расчёта.</translation>
    </message>
    <message>
        <source>%1: minima and maxima before filter, delay and gaps for lost samples; zoom in for the samples of the analysis.</source>
        <translation>%1: минимумы и максимумы до фильтра, задержки и пропусков на месте потерянных отсчётов; отсчёты, как в расчёте, видны при увеличении.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Невязка</translation>
    </message>
    <message>
        <source>Signals over time</source>
        <translation>Сигналы во времени</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::StartFields</name>
    <message>
        <source>Start from</source>
        <translation>Начинать с</translation>
    </message>
    <message>
        <source>First guess of the conjugate gradient for each window: the closed forms (15), (18) of algorithm 1, the result of the window before, or your own values.</source>
        <translation>Начальное приближение сопряжённого градиента в каждом окне: формулы (15), (18) алгоритма 1, результат предыдущего окна или свои значения.</translation>
    </message>
    <message>
        <source>Start value of the functional F&apos;s parameter, in the notation of (6).</source>
        <translation>Начальное значение параметра функционала F в обозначениях (6).</translation>
    </message>
    <message>
        <source>a_A</source>
        <translation>a_A</translation>
    </message>
    <message>
        <source>a_B</source>
        <translation>a_B</translation>
    </message>
    <message>
        <source>2θ_A</source>
        <translation>2θ_A</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>рад</translation>
    </message>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>Phase at the centre of the first window; it is carried on to the others with the frequency.</source>
        <translation>Фаза в центре первого окна; на остальные переносится с частотой.</translation>
    </message>
    <message>
        <source>f</source>
        <translation>f</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>algorithm 1, each window</source>
        <translation>алгоритма 1, каждое окно</translation>
    </message>
    <message>
        <source>previous window</source>
        <translation>предыдущего окна</translation>
    </message>
    <message>
        <source>typed values</source>
        <translation>своих значений</translation>
    </message>
    <message>
        <source>for every window</source>
        <translation>для каждого окна</translation>
    </message>
    <message>
        <source>On: every window starts from the typed values. Off: only the first one, the others from the result of the window before.</source>
        <translation>Включено: каждое окно начинается со своих значений. Выключено: только первое, остальные — с результата предыдущего окна.</translation>
    </message>
    <message>
        <source>of algorithm 5 alone</source>
        <translation>только для алгоритма 5</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::StatusLine</name>
    <message numerus="yes">
        <source>%n window(s) in %1</source>
        <translation>
            <numerusform>%n окно за %1</numerusform>
            <numerusform>%n окна за %1</numerusform>
            <numerusform>%n окон за %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Resonator of %n recording(s) in %1</source>
        <translation>
            <numerusform>Резонатор по %n записи за %1</numerusform>
            <numerusform>Резонатор по %n записям за %1</numerusform>
            <numerusform>Резонатор по %n записям за %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>осталось %1 с</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Идёт расчёт…</translation>
    </message>
    <message>
        <source>Progress of the analysis</source>
        <translation>Ход расчёта</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Прервать</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Прервано</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::SweepPage</name>
    <message>
        <source>No recording is open.</source>
        <translation>Запись не открыта.</translation>
    </message>
    <message>
        <source>The recording is being read.</source>
        <translation>Запись читается.</translation>
    </message>
    <message>
        <source>The windows are being estimated…</source>
        <translation>Окна оцениваются…</translation>
    </message>
    <message>
        <source>Compute estimates this recording once for each length: it shows how much the values scatter and which window is recommended.</source>
        <translation>«Рассчитать» оценивает эту запись один раз для каждой длины и показывает, как разбросаны значения и какое окно рекомендуется.</translation>
    </message>
    <message>
        <source>The result is older than the settings: Compute does it anew.</source>
        <translation>Результат старше настроек: «Рассчитать» вычислит его заново.</translation>
    </message>
    <message>
        <source>Estimates adjacent windows of each length with the settings of the panel Analysis</source>
        <translation>Оценивает примыкающие окна каждой длины с настройками панели «Обработка»</translation>
    </message>
    <message>
        <source>Use n = %1</source>
        <translation>Взять n = %1</translation>
    </message>
    <message>
        <source>Algorithm</source>
        <translation>Алгоритм</translation>
    </message>
    <message>
        <source>Algorithm of the sweep</source>
        <translation>Алгоритм перебора окон</translation>
    </message>
    <message>
        <source>Follows the panel Analysis; may be another one here</source>
        <translation>Следует панели «Обработка»; здесь может быть другим</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>К полупериодам</translation>
    </message>
    <message>
        <source>Snap every length</source>
        <translation>Каждая длина к полупериодам</translation>
    </message>
    <message>
        <source>Moves every length to whole half-periods of the carrier</source>
        <translation>Сдвигает каждую длину к целому числу полупериодов несущей</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Длины окон</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>Рассчитать</translation>
    </message>
    <message>
        <source>Compute the sweep</source>
        <translation>Запустить перебор окон</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Прервать</translation>
    </message>
    <message>
        <source>Cancel the sweep</source>
        <translation>Отменить перебор окон</translation>
    </message>
    <message>
        <source>Progress of the sweep</source>
        <translation>Ход перебора окон</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Переменная</translation>
    </message>
    <message>
        <source>Variable of the sweep</source>
        <translation>Переменная перебора окон</translation>
    </message>
    <message>
        <source>The variable of the left plot and of the table</source>
        <translation>Переменная левого графика и таблицы</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Копировать таблицу</translation>
    </message>
    <message>
        <source>All variables and lengths to the clipboard, for a spreadsheet</source>
        <translation>Все переменные и длины в буфер обмена, для электронной таблицы</translation>
    </message>
    <message>
        <source>Puts this window and the algorithm of the sweep into the panel Analysis; Undo takes them back</source>
        <translation>Записывает это окно и алгоритм перебора на панель «Обработка»; отмена возвращает прежние</translation>
    </message>
    <message>
        <source>Scatter against the length of the window</source>
        <translation>Разброс в зависимости от длины окна</translation>
    </message>
    <message>
        <source>Residual against the length of the window</source>
        <translation>Невязка в зависимости от длины окна</translation>
    </message>
    <message>
        <source>Numbers of the sweep</source>
        <translation>Числа перебора окон</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::TrackView</name>
    <message>
        <source>Slow variables over time</source>
        <translation>Медленные переменные во времени</translation>
    </message>
    <message>
        <source>No analysis yet.
Open a recording and press Keep (F5).</source>
        <translation>Расчётов пока нет.
Откройте запись и нажмите «Закрепить» (F5).</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::TracksPage</name>
    <message>
        <source>Tracks of logs: %1</source>
        <translation>Ряды журналов: %1</translation>
    </message>
    <message>
        <source>%1: %2; window %3, step %4 samples; f0 = %5 Hz</source>
        <translation>%1: %2; окно %3, шаг %4 отсчётов; f0 = %5 Гц</translation>
    </message>
    <message>
        <source>; filter %1 to %2 Hz</source>
        <translation>; фильтр от %1 до %2 Гц</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::WarningList</name>
    <message>
        <source>Only the worst</source>
        <translation>Только самые серьёзные</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::WavePanel</name>
    <message>
        <source>No wave here</source>
        <translation>Здесь волны нет</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 с</translation>
    </message>
    <message>
        <source>Amplitude of the wave around the rim</source>
        <translation>Амплитуда волны по кромке</translation>
    </message>
    <message>
        <source>Amplitude against the angle on the rim, from the electrode of channel C at the top, clockwise: a_A at the four antinodes, |a_B| between them</source>
        <translation>Амплитуда по углу на кромке, от электрода канала C наверху по часовой стрелке: a_A в четырёх пучностях, |a_B| между ними</translation>
    </message>
    <message>
        <source>Ellipse of the channels</source>
        <translation>Эллипс каналов</translation>
    </message>
    <message>
        <source>D against C over one period: the semi-axes are a_A and |a_B|, and the major axis stands at 2θ_A from C</source>
        <translation>D от C за один период: полуоси a_A и |a_B|, большая ось стоит под углом 2θ_A к C</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::WelcomePage</name>
    <message>
        <source>&lt;p style=&apos;font-size:large&apos;&gt;Drop a recording of a free decay here&lt;/p&gt;&lt;p&gt;Two channels, C and D: WAV, FLAC, CSV and other tables of numbers&lt;/p&gt;</source>
        <translation>&lt;p style=&apos;font-size:large&apos;&gt;Перетащите сюда запись свободного выбега&lt;/p&gt;&lt;p&gt;Два канала, C и D: WAV, FLAC, CSV и другие таблицы чисел&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Открыть запись…</translation>
    </message>
    <message>
        <source>A recording of a free decay, or a session</source>
        <translation>Запись свободного выбега или сеанс</translation>
    </message>
    <message>
        <source>Open the demonstration</source>
        <translation>Открыть пример</translation>
    </message>
    <message>
        <source>A simulated free decay: 28 s, 5300 Hz, with a frequency split, a decay and noise</source>
        <translation>Смоделированный свободный выбег: 28 с, 5300 Гц, с разночастотностью, затуханием и шумом</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Недавние файлы</translation>
    </message>
    <message>
        <source>A click or Return opens a file</source>
        <translation>Щелчок или ввод открывает файл</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::WindowFields</name>
    <message>
        <source>Length</source>
        <translation>Длина</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>отсчётов</translation>
    </message>
    <message>
        <source>periods</source>
        <translation>периодов</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>Leakage</source>
        <translation>Утечка</translation>
    </message>
    <message>
        <source>What the window leaves of ⟨cos 2ωt⟩ = ⟨sin 2ωt⟩ = 0, the condition below (7). Algorithms 1 to 4 are exact only where it is zero; 5 and 6 are exact for every window.</source>
        <translation>Насколько окно нарушает ⟨cos 2ωt⟩ = ⟨sin 2ωt⟩ = 0, условие после (7). Алгоритмы 1–4 точны лишь там, где утечки нет; 5 и 6 точны при любом окне.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Шаг</translation>
    </message>
    <message>
        <source>Samples between the starts of windows. Empty: windows one after the other (discrete identification); less than the window: sliding.</source>
        <translation>Отсчётов между началами окон. Пусто: окна одно за другим (дискретная идентификация); меньше окна: скользящее окно.</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Перекрытие</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>The same as a share of the window that the next one repeats.</source>
        <translation>То же как доля окна, которую повторяет следующее.</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>К полупериодам</translation>
    </message>
    <message>
        <source>Moves the window to whole half-periods of the carrier: the n nearest to the wish that leaks least.</source>
        <translation>Подгоняет окно к целому числу полупериодов несущей: ближайшее n с наименьшей утечкой.</translation>
    </message>
    <message>
        <source>Window of n consecutive samples, the averaging interval T of (7). The slow variables are constant inside it. At least 5 samples and three quarters of a period. The article varies T from 1 to 10 periods, which may be fractions.</source>
        <translation>Окно из n отсчётов подряд, интервал усреднения T в (7). Медленные переменные в нём постоянны. Не менее 5 отсчётов и трёх четвертей периода. В статье T меняется от 1 до 10 периодов, возможны дробные.</translation>
    </message>
    <message>
        <source>Unit of the length</source>
        <translation>Единица длины</translation>
    </message>
    <message>
        <source>In which unit the length of the window is typed</source>
        <translation>В какой единице вводится длина окна</translation>
    </message>
    <message>
        <source>= window</source>
        <translation>= окно</translation>
    </message>
    <message>
        <source>leakage %1</source>
        <translation>утечка %1</translation>
    </message>
</context>
<context>
    <name>vybeg::ui::WindowMenus</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;Analysis</source>
        <translation>О&amp;бработка</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Тема</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Как в системе</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <source>&amp;Plots</source>
        <translation>&amp;Графики</translation>
    </message>
    <message>
        <source>Fre&amp;quency in</source>
        <translation>&amp;Частота в</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>рад/с</translation>
    </message>
    <message>
        <source>Deviation from f₀, Hz</source>
        <translation>Отклонение от f₀, Гц</translation>
    </message>
    <message>
        <source>Deviation from f₀, ppm</source>
        <translation>Отклонение от f₀, млн⁻¹</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>&amp;Углы в</translation>
    </message>
    <message>
        <source>Radians</source>
        <translation>Радианы</translation>
    </message>
    <message>
        <source>Degrees</source>
        <translation>Градусы</translation>
    </message>
    <message>
        <source>A&amp;mplitudes in</source>
        <translation>&amp;Амплитуды в</translation>
    </message>
    <message>
        <source>Recording units</source>
        <translation>Единицы записи</translation>
    </message>
    <message>
        <source>Decibels</source>
        <translation>Децибелы</translation>
    </message>
    <message>
        <source>Lang&amp;uage</source>
        <translation>&amp;Язык</translation>
    </message>
    <message>
        <source>&amp;Gyro</source>
        <translation>&amp;Гироскоп</translation>
    </message>
    <message>
        <source>Open rece&amp;nt</source>
        <translation>&amp;Недавние</translation>
    </message>
    <message>
        <source>2θ_A or θ_A, bran&amp;ch</source>
        <translation>2θ_A или θ_A, вы&amp;бор ветви</translation>
    </message>
    <message>
        <source>2θ_A</source>
        <translation>2θ_A</translation>
    </message>
    <message>
        <source>θ_A, continuous</source>
        <translation>θ_A, непрерывно</translation>
    </message>
    <message>
        <source>θ_A from −45° to 45°</source>
        <translation>θ_A от −45° до 45°</translation>
    </message>
    <message>
        <source>θ_A from 0° to 90°</source>
        <translation>θ_A от 0° до 90°</translation>
    </message>
</context>
</TS>
